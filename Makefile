# meshgrade: `make help` lists what can be made.
#
# No recursion, no lists of files: a source is found by where it stands, so adding an exercise edits
# nothing here. Objects go to build/$(config)/, programs also to build/. Here stand the settings, the
# program itself and the goals of daily work; each *.mk stands in the room that it builds:
#
#     graders/runner/runner.mk   what runs in the box         bench/bench.mk     for the benchmark
#     graders/render/render.mk   pictures                     tests/tests.mk     tests of all kinds
#     tests/packages.mk          Debian packages              tests/checks.mk    lint and fuzzing

config ?= release
ifeq ($(MAKECMDGOALS),coverage)
override config := coverage
endif
BUILD := build/$(config)
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := all
ifeq ($(filter -j% --jobs%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc)
endif
# make V=1 shows the commands
V ?= 0
ifeq ($(V),0)
SHOW = @echo "  $(1)" >&2;
else
SHOW =
endif

include tests/packages.mk

# ---------------------------------------------------------------- flags
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wundef \
  -Wformat=2 -Wcast-qual -Wwrite-strings -Wdouble-promotion -Wconversion -Wno-sign-conversion \
  -Wno-missing-field-initializers
MODE_release := -O2 -g
MODE_debug := -O0 -g3
MODE_asan := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
MODE_coverage := -O1 -g -fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation
MODE := $(MODE_$(config))
ifeq ($(MODE),)
$(error config=$(config): choose release, debug, asan or coverage)
endif
LIBRARIES := jansson sqlite3 libarchive libseccomp nettle
CFLAGS := -std=c17 -D_GNU_SOURCE -I. $(MODE) $(WARNINGS) $(shell pkg-config --cflags $(LIBRARIES) 2>/dev/null)
LDLIBS := $(shell pkg-config --libs $(LIBRARIES) 2>/dev/null) -lm
DEPENDENCIES = -MMD -MP

# ---------------------------------------------------------------- the programs
# All sources of these folders, at any depth, are one library; answers and runners are built by
# themselves, the command line is linked last.
LIBRARY_SOURCES := $(shell find reference bench/measure bench/compare graders -name '*.c' \
  -not -path 'reference/answers/*' -not -path 'graders/runner/*' -not -path 'graders/commands/*' \
  -not -path graders/meshgrade.c | sort)
LIBRARY_OBJECTS := $(LIBRARY_SOURCES:%.c=$(BUILD)/%.o) $(BUILD)/judge-table.o \
  $(BUILD)/representation-table.o $(BUILD)/counted-representations.o
JUDGES := $(patsubst %.c,%,$(notdir $(wildcard graders/judges/*/*.c)))

all: build/meshgrade build/meshgrade-render ## build the programs

build/meshgrade: $(BUILD)/meshgrade runners
	@ln -sf $(config)/meshgrade $@

COMMAND_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,graders/meshgrade.c $(wildcard graders/commands/*.c))
$(BUILD)/meshgrade: $(COMMAND_OBJECTS) $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ $(LDLIBS)

$(BUILD)/libmeshgrade.a: $(LIBRARY_OBJECTS)
	@rm -f $@
	@ar qcs $@ $^ 2>/dev/null

# The kernels are what is timed: -O3 unrolls and inlines what they hold in registers (rows of sides are
# filled in 5 ns a triangle instead of 7).
KERNEL_MODE := $(if $(filter release,$(config)),-O3)
$(BUILD)/reference/kernels/%.o: CFLAGS += $(KERNEL_MODE)

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) $(CFLAGS) $(DEPENDENCIES) -c $< -o $@

$(BUILD)/%.o: $(BUILD)/%.c
	$(call SHOW,CC  $<)$(CC) $(CFLAGS) $(DEPENDENCIES) -c $< -o $@

# The table of judges, by name, for graders/judges/table.h.
$(BUILD)/judge-table.c: $(wildcard graders/judges/*) $(wildcard graders/judges/*/*.c) Makefile
	@mkdir -p $(@D)
	@{ echo '#include "graders/judges/table.h"'; \
	  for j in $(subst -,_,$(JUDGES)); do echo "extern const struct judge judge_$$j;"; done; \
	  echo 'const struct judge *const judge_table[] = {'; \
	  for j in $(subst -,_,$(JUDGES)); do echo "    &judge_$$j,"; done; \
	  echo '    NULL};'; } >$@

# The table of representations, by their .order, for reference/representation/representation.h.
REPRESENTATION_SOURCES := $(wildcard reference/representation/*.c)
$(BUILD)/representation-table.c: reference/representation $(REPRESENTATION_SOURCES) Makefile
	@mkdir -p $(@D)
	@names=$$(awk '/^const struct representation representation_/ {name = $$4} \
	    /^    \.order = / {print $$3 + 0, name}' $(REPRESENTATION_SOURCES) | sort -n | cut -d' ' -f2); \
	{ echo '#include "reference/representation/representation.h"'; \
	  for r in $$names; do echo "extern const struct representation $$r;"; done; \
	  echo 'const struct representation *const representation_table[] = {'; \
	  for r in $$names; do echo "    &$$r,"; done; \
	  echo '    NULL};'; } >$@

# ---------------------------------------------------------------- rooms
include bench/bench.mk
include graders/runner/runner.mk
include graders/render/render.mk
include tests/tests.mk
include tests/checks.mk

# ---------------------------------------------------------------- the demonstration
# Enough to see each kind of exercise and of report.
DEMO_EXERCISES := edge-table-any edge-table-closed memory-indexed-grid memory-strips memory-voxels-vs-mesh \
  mesh-area winged-edge-build euler-closed-mesh
demo: EXERCISES := $(DEMO_EXERCISES)
demo: all ## grade a class of real submissions; the report is build/demo/index.html
demo-all: all ## the same class on every exercise; the report is build/demo-all/index.html
demo demo-all:
	@tests/demo-class.sh build/$@-class $(EXERCISES)
	@code=0; build/meshgrade grade build/$@-class/folders build/$@-class/*.zip build/$@-class/*.tar.gz \
	  -o build/$@ --seed 2026 || code=$$?; [ $$code -le 1 ]

bench-grader: all ## what a verdict costs, and where the time goes
	@tests/bench-grader.sh

deps: ## install the Debian packages that the build and the demo need
	@echo "meshgrade: every package is installed"

clean: ## remove build/
	rm -rf build

help: ## this list
	@echo "make [goal] [config=release|debug|asan|coverage]"
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  \1\t\2/p' $(filter-out %.d,$(MAKEFILE_LIST)) | expand -t 18

.PHONY: all peers unit test validate demo demo-all bench-grader growth pace stability lint format fuzz replays deps clean help
-include $(shell find build -name '*.d' 2>/dev/null)
