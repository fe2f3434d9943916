# Checks of the sources, and fuzzing.

# ---------------------------------------------------------------- source checks
C_FILES = $(shell git ls-files -co --exclude-standard '*.c' '*.h' 2>/dev/null | grep -v '^tests/submissions/\|^tests/hostile/[c-z]')
CXX_FILES = $(shell git ls-files -co --exclude-standard '*.cpp' '*.hpp' 2>/dev/null)
LINT_SOURCES = $(filter %.c,$(LIBRARY_SOURCES) graders/meshgrade.c $(wildcard graders/commands/*.c))

# One stamp a file, so that files are looked at on all cores and again only when they have changed.
LINT_STAMPS = $(LINT_SOURCES:%=build/lint/%.ok)
build/lint/%.ok: % .clang-tidy
	@mkdir -p $(@D)
	$(call SHOW,LINT $<)clang-tidy --quiet $< -- $(CFLAGS) 2>$@.log || { cat $@.log; exit 1; }
	@cppcheck --quiet --error-exitcode=1 --enable=warning,portability --inline-suppr -I. \
	  --suppress=internalAstError $<
	@$(CC) $(CFLAGS) -Werror -DANALYZER -fanalyzer -Wno-analyzer-malloc-leak -MMD -MP -MF build/lint/$*.d -MT $@ \
	  -c $< -o /dev/null
	@touch $@
lint: all $(LINT_STAMPS) ## structure, clang-format, clang-tidy, cppcheck, gcc -fanalyzer
	@clang-format --dry-run -Werror $(C_FILES) $(CXX_FILES)
	@tests/lint/structure.py

format: ## lay out every C and C++ file
	@clang-format -i $(C_FILES) $(CXX_FILES)

# ---------------------------------------------------------------- fuzzing
# The same targets for both: libFuzzer's entry point, which AFL++'s driver calls as well. The library is
# compiled once for each.
TIME ?= 60
FUZZ_SUPPORT := $(filter-out tests/fuzz/replay.c $(wildcard tests/fuzz/fuzz_*.c),$(wildcard tests/fuzz/*.c))
FUZZ_TARGETS := $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
# The benchmark reads no foreign bytes.
FUZZ_SOURCES := $(filter-out bench/compare/%,$(LIBRARY_SOURCES))
FUZZ_OBJECTS := $(FUZZ_SOURCES:%.c=%.o) $(FUZZ_SUPPORT:%.c=%.o) judge-table.o representation-table.o
FUZZ_FLAGS := -std=c17 -D_GNU_SOURCE -I. -O1 -g
FUZZ_CC_fuzz := clang
FUZZ_CC_afl := afl-clang-fast
SANITIZE_fuzz := -fsanitize=address,undefined -fno-sanitize-recover=all
SANITIZE_afl := -fsanitize=undefined -fno-sanitize-recover=all

# $(1): fuzz or afl
define fuzz_rules
build/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$$(call SHOW,CC  $$< ($(1)))$(FUZZ_CC_$(1)) $(FUZZ_FLAGS) $(SANITIZE_$(1)) $(COVER_$(1)) $$(DEPENDENCIES) -c $$< -o $$@
build/$(1)/%-table.o: $(BUILD)/%-table.c
	@mkdir -p $$(@D)
	@$(FUZZ_CC_$(1)) $(FUZZ_FLAGS) $(SANITIZE_$(1)) -c $$< -o $$@
$(FUZZ_TARGETS:%=build/$(1)/%): build/$(1)/%: build/$(1)/tests/fuzz/%.o $(FUZZ_OBJECTS:%=build/$(1)/%)
	$$(call SHOW,LD  $$@)$(FUZZ_CC_$(1)) $(SANITIZE_$(1)) -fsanitize=fuzzer $$^ -o $$@ $(LDLIBS)
endef
COVER_fuzz := -fsanitize=fuzzer-no-link
$(foreach kind,fuzz afl,$(eval $(call fuzz_rules,$(kind))))

fuzz: $(FUZZ_TARGETS:%=build/fuzz/%) ## libFuzzer: every reader of foreign bytes, TIME seconds each
	@tests/fuzz/run libfuzzer $(TIME)
.PHONY: fuzz-afl
fuzz-afl: $(FUZZ_TARGETS:%=build/afl/%) ## the same targets with AFL++
	@tests/fuzz/run afl $(TIME)

# The corpora once more in every test run, by a plain main instead of libFuzzer.
REPLAYS := $(patsubst tests/fuzz/%.c,$(BUILD)/tests/fuzz/%,$(wildcard tests/fuzz/fuzz_*.c))
$(REPLAYS): $(BUILD)/tests/fuzz/%: $(BUILD)/tests/fuzz/%.o $(BUILD)/tests/fuzz/replay.o \
  $(FUZZ_SUPPORT:%.c=$(BUILD)/%.o) $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ $(LDLIBS)
replays: $(REPLAYS)
