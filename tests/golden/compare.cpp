/* Compares pictures with the golden ones and prints a line of TAP each:
 *
 *     compare GOLDEN_FOLDER MADE_FOLDER
 *
 * Processors and Mesa versions may round a pixel differently, so a picture passes when at most 0.05
 * % of its pixels differ by more than 2 % and the root mean square difference is below 0.002. Also
 * checks what the pictures carry as text. The exit code is 0 when everything passed. */
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

static int failure_count;

static void report(bool passed, const std::string &name, const std::string &why)
{
    failure_count += !passed;
    std::printf("%s - %s%s%s\n", passed ? "ok" : "not ok", name.c_str(), passed ? "" : ": ",
                passed ? "" : why.c_str());
}

static std::set<std::string> pictures_in(const std::string &folder)
{
    std::set<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".png")
            names.insert(entry.path().filename().string());
    return names;
}

static void compare_picture(const std::string &golden, const std::string &made,
                            const std::string &name)
{
    const float fail = .02f, warn = .004f;
    const double failed_share = .0005, rms_limit = .002;
    OIIO::ImageBuf a(golden + "/" + name), b(made + "/" + name);
    if (!a.read() || !b.read())
        return report(false, name, a.has_error() ? a.geterror() : b.geterror());
    if (a.spec().width != b.spec().width || a.spec().height != b.spec().height)
        return report(false, name, "another size");
    OIIO::ImageBufAlgo::CompareResults result = OIIO::ImageBufAlgo::compare(a, b, fail, warn);
    double pixels = double(a.spec().image_pixels());
    char why[160];
    std::snprintf(why, sizeof why, "%llu of %.0f pixels differ, rms %.5f, most %.3f",
                  static_cast<unsigned long long>(result.nfail), pixels, result.rms_error,
                  result.maxerror);
    report(double(result.nfail) <= failed_share * pixels && result.rms_error < rms_limit, name,
           why);
}

static void check_text(const OIIO::ImageBuf &picture, const std::string &key,
                       const std::string &expected)
{
    std::string found = picture.spec().get_string_attribute(key);
    report(found == expected, "a picture carries " + key, "\"" + found + "\"");
}

static void check_metadata(const std::string &made)
{
    OIIO::ImageBuf picture(made + "/edges.png");
    if (!picture.read())
        return report(false, "edges.png has metadata", picture.geterror());
    check_text(picture, "meshgrade:exercise", "golden");
    check_text(picture, "meshgrade:case", "edges");
    check_text(picture, "meshgrade:verdict", "wrong-answer");
    check_text(picture, "meshgrade:seed", "7");
    check_text(picture, "meshgrade:student", "Zo\xc3\xab \xce\xa9 [31mred");
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: compare GOLDEN_FOLDER MADE_FOLDER\n");
        return 64;
    }
    std::set<std::string> golden = pictures_in(argv[1]), made = pictures_in(argv[2]);
    for (const std::string &name : golden)
        compare_picture(argv[1], argv[2], name);
    for (const std::string &name : made)
        if (!golden.count(name))
            report(false, name, "there is no golden picture; tests/golden/record.sh records it");
    check_metadata(argv[2]);
    return failure_count > 0;
}
