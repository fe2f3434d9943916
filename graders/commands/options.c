/* Parses options by a table; see options.h. */
#include "graders/commands/options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OPTIONS_MAX = 16, LONG_ONLY = 256 };

static void print_help(const struct command *command, const struct option_rule *rules)
{
    printf("usage: meshgrade %s [options] %s\n%s\n", command->name, command->arguments,
           command->help);
    for (const struct option_rule *rule = rules; rule->name; rule++) {
        char left[64];
        snprintf(left, sizeof left, "%c%c%s --%s%s%s", rule->letter ? '-' : ' ',
                 rule->letter ? rule->letter : ' ', rule->letter ? "," : " ", rule->name,
                 rule->argument ? " " : "", rule->argument ? rule->argument : "");
        printf("  %-26s %s\n", left, rule->help);
    }
    printf("  %-26s %s\n", "-h, --help", "this help");
}

static void build_tables(const struct option_rule *rules, struct option *longs, char *shorts)
{
    int count = 0;
    *shorts++ = 'h';
    for (const struct option_rule *rule = rules; rule->name && count < OPTIONS_MAX; rule++) {
        longs[count] = (struct option){rule->name, rule->argument ? required_argument : no_argument,
                                       NULL, LONG_ONLY + count};
        count++;
        if (rule->letter)
            *shorts++ = rule->letter;
        if (rule->letter && rule->argument)
            *shorts++ = ':';
    }
    longs[count] = (struct option){"help", no_argument, NULL, 'h'};
    longs[count + 1] = (struct option){NULL, 0, NULL, 0};
    *shorts = '\0';
}

static const struct option_rule *rule_of(const struct option_rule *rules, int code)
{
    if (code >= LONG_ONLY)
        return &rules[code - LONG_ONLY];
    for (const struct option_rule *rule = rules; rule->name; rule++)
        if (rule->letter == code)
            return rule;
    return NULL;
}

int options_parse(const struct command *command, const struct option_rule *rules, int argc,
                  char **argv)
{
    struct option longs[OPTIONS_MAX + 2];
    char shorts[2 * OPTIONS_MAX + 2];
    int code;
    build_tables(rules, longs, shorts);
    optind = 1;
    while ((code = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        if (code == 'h') {
            print_help(command, rules);
            exit(EXIT_PASSED);
        }
        const struct option_rule *rule = rule_of(rules, code);
        if (!rule) {
            fprintf(stderr, "meshgrade: see meshgrade %s --help\n", command->name);
            return -1;
        }
        if (rule->text)
            *rule->text = optarg;
        if (rule->flag)
            *rule->flag = true;
    }
    return optind;
}

long options_number(const char *name, const char *text, long least, long absent)
{
    char *end;
    if (!text)
        return absent;
    long number = strtol(text, &end, 10);
    if (end == text || *end != '\0' || number < least) {
        fprintf(stderr, "meshgrade: --%s %s: expected a whole number of at least %ld\n", name, text,
                least);
        return -1;
    }
    return number;
}

int options_seed(const char *text, uint32_t absent, uint32_t *seed)
{
    long number = options_number("seed", text, 1, (long)absent);
    if (number > (long)UINT32_MAX) {
        fprintf(stderr, "meshgrade: --seed %s: expected a whole number of at most %lu\n", text,
                (unsigned long)UINT32_MAX);
        number = -1;
    }
    *seed = number >= 0 ? (uint32_t)number : 0;
    return number >= 0 ? 0 : -1;
}

int options_language(const char *text, enum language absent, enum language *language)
{
    *language = !text ? absent : strcmp(text, "es") == 0 ? LANGUAGE_ES : LANGUAGE_EN;
    if (!text || strcmp(text, "en") == 0 || strcmp(text, "es") == 0)
        return 0;
    fprintf(stderr, "meshgrade: --lang %s: expected en or es\n", text);
    return -1;
}
