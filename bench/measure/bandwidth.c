/* How fast this core copies memory; see bandwidth.h. */
#include "bench/measure/bandwidth.h"

#include "bench/measure/clock.h"

#include <math.h>
#include <string.h>
#include <sys/mman.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

static const int64_t SAMPLE_NS = 1000000;

static void copy_plain(char *to, const char *from, size_t bytes)
{
    memcpy(to, from, bytes);
    __asm__ volatile("" : : "r"(to) : "memory");
}

#ifdef __SSE2__
/* bytes: a multiple of 64; both 64-byte aligned */
static void copy_past_the_caches(char *to, const char *from, size_t bytes)
{
    for (size_t at = 0; at < bytes; at += 64) {
        const __m128i *source = (const __m128i *)(const void *)(from + at);
        __m128i *target = (__m128i *)(void *)(to + at);
        __m128i a = _mm_load_si128(source), b = _mm_load_si128(source + 1);
        __m128i c = _mm_load_si128(source + 2), d = _mm_load_si128(source + 3);
        _mm_stream_si128(target, a);
        _mm_stream_si128(target + 1, b);
        _mm_stream_si128(target + 2, c);
        _mm_stream_si128(target + 3, d);
    }
    _mm_sfence();
}
#endif

static double best_of(void (*copy)(char *, const char *, size_t), char *to, const char *from,
                      size_t bytes, int repetitions)
{
    double best = 0;
    copy(to, from, bytes);
    for (int i = 0; i < repetitions; i++) {
        int64_t start = clock_thread_cpu_ns(), elapsed_ns, copies = 0;
        do {
            copy(to, from, bytes);
            copies++;
        } while ((elapsed_ns = clock_thread_cpu_ns() - start) < SAMPLE_NS);
        double rate = 2 * (double)bytes * (double)copies / (double)elapsed_ns;
        if (rate > best)
            best = rate;
    }
    return best;
}

int copy_bandwidth_measure(int64_t working_set_bytes, int repetitions,
                           struct copy_bandwidth *bandwidth, struct error *err)
{
    if (working_set_bytes < 4096 || working_set_bytes > (INT64_C(1) << 32))
        return error_set(err, "copy bandwidth: a working set of %lld bytes is out of range",
                         (long long)working_set_bytes);
    size_t half = (size_t)working_set_bytes / 2 / 64 * 64;
    char *memory = mmap(NULL, 2 * half, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        return error_set(err, "out of memory: %zu bytes to copy", 2 * half);
    madvise(memory, 2 * half, MADV_HUGEPAGE); /* a wish: without it the copy is slower */
    memset(memory, 1, 2 * half);
    *bandwidth = (struct copy_bandwidth){
        .working_set_bytes = working_set_bytes,
        .method = "memcpy",
        .gigabytes_per_second = best_of(copy_plain, memory + half, memory, half, repetitions)};
#ifdef __SSE2__
    double streamed = best_of(copy_past_the_caches, memory + half, memory, half, repetitions);
    if (streamed > bandwidth->gigabytes_per_second) {
        bandwidth->method = "non-temporal";
        bandwidth->gigabytes_per_second = streamed;
    }
#endif
    munmap(memory, 2 * half);
    return 0;
}

double copy_bandwidth_at(const struct copy_bandwidth *table, int count, int64_t working_set_bytes)
{
    double nearest = INFINITY, found = 0;
    for (int i = 0; i < count; i++) {
        double distance = fabs(log((double)working_set_bytes / (double)table[i].working_set_bytes));
        if (distance < nearest) {
            nearest = distance;
            found = table[i].gigabytes_per_second;
        }
    }
    return found;
}
