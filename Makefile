# meshgrade: `make help` lists what can be made.
#
# No recursion, no lists of files: a source is found by where it stands, so adding an exercise edits
# nothing here. Objects go to build/$(config)/, programs also to build/.

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

# ---------------------------------------------------------------- packages
CORE_PACKAGES := gcc libc6-dev make binutils pkg-config libjansson-dev libsqlite3-dev libarchive-dev \
  libseccomp-dev nettle-dev valgrind
PICTURE_PACKAGES := g++ libvtk9-dev libopenimageio-dev libegl-dev libegl1 libgl1-mesa-dri fonts-open-sans \
  libjs-three
DEMO_PACKAGES := zip
TEST_PACKAGES := libcmocka-dev chromium python3 procps
PEER_PACKAGES := g++ libopenmesh-dev libcgal-dev libmeshoptimizer-dev libassimp-dev libvtk9-dev
LINT_PACKAGES := clang-format clang-tidy cppcheck
FUZZ_PACKAGES := clang libclang-rt-14-dev
AFL_PACKAGES := afl++
COVERAGE_PACKAGES := clang llvm libclang-rt-14-dev

PACKAGES := $(CORE_PACKAGES) $(PICTURE_PACKAGES) $(DEMO_PACKAGES)
ifneq ($(filter test unit stability mutants faults hostile box-cost,$(MAKECMDGOALS)),)
PACKAGES += $(TEST_PACKAGES)
endif
ifneq ($(filter lint format,$(MAKECMDGOALS)),)
PACKAGES += $(LINT_PACKAGES)
endif
ifneq ($(filter fuzz fuzz-afl,$(MAKECMDGOALS)),)
PACKAGES += $(FUZZ_PACKAGES)
endif
ifneq ($(filter fuzz-afl,$(MAKECMDGOALS)),)
PACKAGES += $(AFL_PACKAGES)
endif
ifneq ($(filter peers,$(MAKECMDGOALS)),)
PACKAGES += $(PEER_PACKAGES)
endif
ifneq ($(filter coverage,$(MAKECMDGOALS)),)
PACKAGES += $(TEST_PACKAGES) $(COVERAGE_PACKAGES)
endif
SELF_PREPARING := deps demo test unit validate lint format fuzz stability bench-grader growth pace
SELF_PREPARING += mutants faults fuzz-afl coverage peers hostile box-cost

# These goals install what they lack. Make includes build/deps.mk, finds that it must be made, makes
# it (the installation) and starts itself anew with the packages in place.
ifneq ($(filter $(SELF_PREPARING),$(MAKECMDGOALS)),)
installed = $(shell dpkg-query -W -f '$${db:Status-Status} $${Package}\n' $(1) 2>/dev/null | sed -n 's/^installed //p')
MISSING := $(filter-out $(call installed,$(PACKAGES)),$(PACKAGES))
ifneq ($(strip $(MISSING)),)
include build/deps.mk
build/deps.mk: force
	@root=; if [ "$$(id -u)" != 0 ]; then root=sudo; command -v sudo >/dev/null || { \
	  echo "meshgrade: packages are missing and there is no sudo; as root, run:" >&2; \
	  echo "  apt-get install --no-install-recommends $(MISSING)" >&2; exit 1; }; fi; \
	echo "meshgrade: installing Debian packages: $(MISSING)" >&2; \
	$$root apt-get update -q >/dev/null && \
	$$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $(MISSING) >/dev/null
	@mkdir -p build && touch $@
endif
endif
force:
.PHONY: force

# ---------------------------------------------------------------- flags
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wundef \
  -Wformat=2 -Wcast-qual -Wwrite-strings -Wdouble-promotion -Wconversion -Wno-sign-conversion
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
LIBRARY_SOURCES := $(wildcard reference/base/*.c reference/mesh/*.c reference/formats/*.c \
  reference/representation/*.c reference/kernels/*.c bench/measure/*.c bench/compare/*.c graders/wire/*.c \
  graders/box/*.c graders/engine/*.c graders/engine/*/*.c graders/known/*.c graders/scene/*.c graders/library/*.c graders/judges/*.c graders/judges/*/*.c \
  graders/report/*.c graders/report/*/*.c)
LIBRARY_OBJECTS := $(LIBRARY_SOURCES:%.c=$(BUILD)/%.o) $(BUILD)/judge-table.o \
  $(BUILD)/representation-table.o $(BUILD)/counted-representations.o
JUDGES := $(patsubst %.c,%,$(notdir $(wildcard graders/judges/*/*.c)))
CALLS := $(wildcard graders/runner/*/*.c)
FLAVOURS := plain sanitized checked
RUNNERS := $(foreach c,$(CALLS),$(foreach f,$(FLAVOURS),build/runner/$(basename $(notdir $(c))).$(f).o))

all: build/meshgrade build/meshgrade-render ## build the programs

build/meshgrade: $(BUILD)/meshgrade $(RUNNERS)
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

# ---------------------------------------------------------------- the benchmark
# Preloaded into what `meshgrade bench --counts` counts allocations of.
all: $(BUILD)/bench-allocations.so
$(BUILD)/bench-allocations.so: bench/preload/allocations.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) -std=c17 -D_GNU_SOURCE -I. -O2 -g -fPIC -shared $(WARNINGS) $(DEPENDENCIES) $< -o $@
$(BUILD)/bench/measure/machine.o: CFLAGS += -DBUILD_FLAGS='"$(MODE)"'

# The representations once more, with a call before every read (bench/compare/counted_reads.h), as one
# object with a single name. Instrumented the same in every configuration.
COUNTED_SOURCES := $(wildcard reference/base/*.c reference/mesh/*.c reference/representation/*.c)
COUNTED_OBJECTS := $(COUNTED_SOURCES:%.c=$(BUILD)/counted/%.o) $(BUILD)/counted/representation-table.o
COUNTED_NAMES := memcpy memcmp representation_table
COUNTED_FLAGS := -std=c17 -D_GNU_SOURCE -I. -O1 -g -fsanitize=thread $(WARNINGS) \
  $(foreach n,$(COUNTED_NAMES),-D$(n)=counted_$(n))
$(BUILD)/counted-representations.o: $(COUNTED_OBJECTS)
	@ld -r $^ -o $@.tmp
	@objcopy --keep-global-symbol=counted_representation_table $@.tmp $@
	@rm $@.tmp
$(BUILD)/counted/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $< (counted))$(CC) $(COUNTED_FLAGS) $(DEPENDENCIES) -c $< -o $@
$(BUILD)/counted/representation-table.o: $(BUILD)/representation-table.c
	@mkdir -p $(@D)
	@$(CC) $(COUNTED_FLAGS) $(DEPENDENCIES) -c $< -o $@

# Other libraries, each in a worker of its own, built as their users would.
PEERS := $(filter-out peer,$(patsubst bench/peers/%.cpp,%,$(wildcard bench/peers/*.cpp)))
PEER_FLAGS := -std=c++17 -O2 -DNDEBUG -I. -Wall -Wextra -Wno-maybe-uninitialized -isystem $(firstword $(wildcard /usr/include/vtk-9.*) /usr/include)
PEER_VTK := CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersExtraction IOGeometry IOPLY
PEER_LIBRARIES_openmesh = -lOpenMeshTools -lOpenMeshCore
PEER_LIBRARIES_cgal = -lgmp -lmpfr
PEER_LIBRARIES_openmesh-paper = $(PEER_LIBRARIES_openmesh)
PEER_LIBRARIES_cgal-paper = $(PEER_LIBRARIES_cgal)
PEER_LIBRARIES_meshoptimizer = -lmeshoptimizer
PEER_LIBRARIES_assimp = -lassimp
PEER_LIBRARIES_vtk = $(foreach m,$(PEER_VTK),-lvtk$(m)-$(patsubst vtk-%,%,$(notdir $(firstword $(wildcard /usr/include/vtk-9.*)))))
peers: build/meshgrade $(PEERS:%=build/peers/%) ## build what measures other libraries, for bench --peers
build/peers/%: build/peers/%.o build/peers/peer.o $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CXX) $^ -o $@ $(PEER_LIBRARIES_$*) -lm
build/peers/%.o: bench/peers/%.cpp
	@mkdir -p $(@D)
	$(call SHOW,CXX $<)$(CXX) $(PEER_FLAGS) $(DEPENDENCIES) -c $< -o $@

# ---------------------------------------------------------------- the runner
# One relocatable object an exercise, with every name local but main and the allocation shim, so that
# a submission can neither call into it nor replace parts of it. Always optimised: it is the same in
# every configuration. Flavours: plain has the allocation shim; sanitized and checked leave allocation to
# the sanitizers and to valgrind's memcheck.
RUNNER_FLAGS := -std=c17 -D_GNU_SOURCE -I. -O2 -g -fno-sanitize=all $(WARNINGS)
RUNNER_PARTS := $(patsubst %.c,%,$(wildcard graders/runner/*.c graders/wire/*.c))
SHIM := malloc calloc realloc free aligned_alloc posix_memalign memalign valloc
RUNNER_NAMES := main $(SHIM:%=__wrap_%) __ubsan_default_options
FLAVOUR_plain :=
FLAVOUR_sanitized := -DRUNNER_WITHOUT_SHIM
FLAVOUR_checked := -DRUNNER_WITHOUT_SHIM

build/runner/plain/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) $(RUNNER_FLAGS) $(DEPENDENCIES) -c $< -o $@
build/runner/sanitized/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) $(RUNNER_FLAGS) $(FLAVOUR_sanitized) $(DEPENDENCIES) -c $< -o $@
build/runner/checked/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) $(RUNNER_FLAGS) $(FLAVOUR_checked) $(DEPENDENCIES) -c $< -o $@

# $(1): <group>/<name> of the exercise, $(2): the flavour
define runner_rules
build/runner/$(2)/graders/runner/$(1).o: graders/runner/$(1).c
	@mkdir -p $$(@D)
	$$(call SHOW,CC  $$<)$$(CC) $$(RUNNER_FLAGS) -Iexercises/$(1) $$(FLAVOUR_$(2)) $$(DEPENDENCIES) -c $$< -o $$@
build/runner/$(notdir $(1)).$(2).o: build/runner/$(2)/graders/runner/$(1).o $(RUNNER_PARTS:%=build/runner/$(2)/%.o)
	@ld -r $$^ -o $$@.tmp
	@objcopy $(RUNNER_NAMES:%=--keep-global-symbol=%) \
	$$@.tmp $$@
	@rm $$@.tmp
endef
$(foreach c,$(CALLS:graders/runner/%.c=%),$(foreach f,$(FLAVOURS),$(eval $(call runner_rules,$(c),$(f)))))

# ---------------------------------------------------------------- the renderer
VTK_INCLUDE := $(firstword $(wildcard /usr/include/vtk-9.*))
HAVE_RENDERER := $(and $(VTK_INCLUDE),$(shell pkg-config --exists OpenImageIO 2>/dev/null && echo yes))
RENDER_SOURCES := $(wildcard graders/render/*.cpp)
ifneq ($(and $(HAVE_RENDERER),$(RENDER_SOURCES)),)
VTK_VERSION := $(patsubst vtk-%,%,$(notdir $(VTK_INCLUDE)))
VTK_MODULES := ChartsCore CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms \
  FiltersCore FiltersGeneral FiltersSources InteractionStyle RenderingAnnotation RenderingContext2D \
  RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI
VTK_LIBRARIES := $(foreach m,$(VTK_MODULES),-lvtk$(m)-$(VTK_VERSION)) -lvtksys-$(VTK_VERSION)
CXXFLAGS := -std=c++17 -I. $(MODE) -Wall -Wextra -Wshadow -isystem $(VTK_INCLUDE) $(shell pkg-config --cflags OpenImageIO freetype2)

build/meshgrade-render: $(BUILD)/meshgrade-render
	@ln -sf $(config)/meshgrade-render $@
$(BUILD)/meshgrade-render: $(RENDER_SOURCES:%.cpp=$(BUILD)/%.o)
	$(call SHOW,LD  $@)$(CXX) $(MODE) $^ -o $@ $(VTK_LIBRARIES) $(shell pkg-config --libs OpenImageIO jansson) -lEGL -ldl -lm
$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	$(call SHOW,CXX $<)$(CXX) $(CXXFLAGS) $(DEPENDENCIES) -c $< -o $@
else
build/meshgrade-render:
	@echo "meshgrade: VTK or OpenImageIO is not installed: built without pictures (make deps installs both)" >&2
endif

# ---------------------------------------------------------------- tests
UNIT_TESTS := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/unit/test_*.c))
UNIT_SUPPORT := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(wildcard tests/unit/test_*.c),$(wildcard tests/unit/*.c)))

$(UNIT_TESTS): $(BUILD)/tests/unit/%: $(BUILD)/tests/unit/%.o $(UNIT_SUPPORT) $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ -lcmocka $(LDLIBS)

# The answers that the plain kernels are compared with.
YARDSTICKS := edges/edge-table-any edges/edge-table-closed processing/mesh-area
$(BUILD)/tests/unit/test_kernels_yardstick: $(YARDSTICKS:%=$(BUILD)/reference/answers/%.o)
$(YARDSTICKS:%=$(BUILD)/reference/answers/%.o): CFLAGS += $(YARDSTICKS:%=-Iexercises/%)

unit: $(UNIT_TESTS) $(RUNNERS) ## build and run the unit tests
	@failed=0; for t in $(UNIT_TESTS); do echo "== $$t"; $$t || failed=1; done; exit $$failed

test: all $(UNIT_TESTS) replays $(BUILD)/tests/growth/known ## every test; ends with "N passed, N failed, N skipped"
	@tests/run $(BUILD)

validate: all ## every known-verdict submission gets its verdict
	@build/meshgrade validate

# ---------------------------------------------------------------- the demonstration
demo: all ## grade a class of real submissions; the report is build/demo/index.html
	@tests/demo-class.sh build/demo-class
	@code=0; build/meshgrade grade build/demo-class/folders build/demo-class/*.zip build/demo-class/*.tar.gz \
	  -o build/demo --seed 2026 || code=$$?; [ $$code -le 1 ]

bench-grader: all ## what a verdict costs, and where the time goes
	@tests/bench-grader.sh

# Programs that check the grader's decisions on real solutions; see bench/measure/README.md.
$(BUILD)/tests/growth/known: $(BUILD)/tests/growth/known.o $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ $(LDLIBS)
DECISIONS ?= 1000
$(BUILD)/tests/pace/two_witness: $(BUILD)/tests/pace/two_witness.o $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ $(LDLIBS)
pace: all $(BUILD)/tests/pace/two_witness ## how often the witness of time is wrong, under load, in DECISIONS
	@$(BUILD)/tests/pace/two_witness $(DECISIONS)
growth: all $(BUILD)/tests/growth/known ## the growth decision on some hundred solutions of known growth
	@$(BUILD)/tests/growth/known

RUNS ?= 5
CLASS ?= known
stability: all ## grade CLASS (known, demo) RUNS times in different surroundings; counts what differs
	@tests/stability.sh $(RUNS) $(CLASS)

# ---------------------------------------------------------------- the grader graded
SAMPLE ?= 40
MUTANT_JUDGE := $(BUILD)/tests/mutants/judge_mutants
$(MUTANT_JUDGE): $(BUILD)/tests/mutants/judge_mutants.o $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ $(LDLIBS)
test: $(MUTANT_JUDGE)
.PHONY: mutants
mutants: all $(MUTANT_JUDGE) ## mutants of right answers against the judges, SAMPLE a file (0: all); NAME=exercise
	@tests/mutants/run --program $(MUTANT_JUDGE) --sample $(SAMPLE) $(NAME:%=--exercise %)

# ---------------------------------------------------------------- faults of the machine
POINTS ?= 50
INJECTOR := $(BUILD)/tests/faults/inject.so
$(INJECTOR): tests/faults/inject.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(CC) -std=c17 -D_GNU_SOURCE -O1 -fPIC -shared $(WARNINGS) $< -o $@
test: $(INJECTOR)
.PHONY: faults
faults: all $(INJECTOR) ## fail POINTS of the grader's calls of each kind (0: all) and look what comes of it
	@code=0; tests/faults/sweep $(INJECTOR) --points $(POINTS) --full || code=1; \
	  tests/faults/sweep $(INJECTOR) --points $(POINTS) --grade || code=1; exit $$code

# ---------------------------------------------------------------- coverage
# By clang, whose counters survive a killed process; see tests/coverage/run.
$(if $(filter coverage,$(config)),$(eval $(BUILD)/%: CC := clang))
.PHONY: coverage
coverage: build/meshgrade $(UNIT_TESTS) replays $(INJECTOR) $(MUTANT_JUDGE) ## which lines the tests execute, per folder
	@tests/coverage/run $(BUILD)

# ---------------------------------------------------------------- the hostile suite
LAYERS ?= none
hostile: all ## every hostile submission, as root and as a plain user; LAYERS="none each": each layer left out in turn
	@code=0; tests/hostile/run $(LAYERS:%=--without %) || code=1; tests/hostile/run --table; exit $$code

.PHONY: hostile box-cost
BOX_COST := $(BUILD)/tests/hostile/box/start_cost
$(BOX_COST): $(BOX_COST).o $(UNIT_SUPPORT) $(BUILD)/libmeshgrade.a
	$(call SHOW,LD  $@)$(CC) $(MODE) $^ -o $@ -lcmocka $(LDLIBS)
box-cost: $(BOX_COST) ## what each layer of the box costs when a program is started
	@$(BOX_COST)

# ---------------------------------------------------------------- source checks
C_FILES = $(shell git ls-files '*.c' '*.h' 2>/dev/null | grep -v '^tests/submissions/\|^tests/hostile/[c-z]')
CXX_FILES = $(shell git ls-files '*.cpp' '*.hpp' 2>/dev/null)
LINT_SOURCES = $(filter %.c,$(LIBRARY_SOURCES) graders/meshgrade.c $(wildcard graders/commands/*.c))

# One stamp a file, so that files are looked at on all cores and again only when they have changed.
LINT_STAMPS = $(LINT_SOURCES:%=build/lint/%.ok)
build/lint/%.ok: % .clang-tidy
	@mkdir -p $(@D)
	$(call SHOW,LINT $<)clang-tidy --quiet $< -- $(CFLAGS) 2>$@.log || { cat $@.log; exit 1; }
	@cppcheck --quiet --error-exitcode=1 --enable=warning,portability --inline-suppr -I. \
	  --suppress=internalAstError $<
	@$(CC) $(CFLAGS) -Werror -fanalyzer -Wno-analyzer-malloc-leak -MMD -MP -MF build/lint/$*.d -MT $@ \
	  -c $< -o /dev/null
	@touch $@
lint: all $(LINT_STAMPS) ## clang-format, clang-tidy, cppcheck, gcc -fanalyzer
	@! grep -nE '\b(glob|wordexp)(64)? *\(' $(filter-out tests/%,$(C_FILES)) || \
	  { echo "a path is no pattern: reference/base/listing.h reads a folder" >&2; exit 1; }
	@clang-format --dry-run -Werror $(C_FILES) $(CXX_FILES)

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

deps: ## install the Debian packages that the build and the demo need
	@echo "meshgrade: every package is installed"

clean: ## remove build/
	rm -rf build

help: ## this list
	@echo "make [goal] [config=release|debug|asan|coverage]"
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  \1\t\2/p' $(MAKEFILE_LIST) | expand -t 18

.PHONY: all peers unit test validate demo bench-grader growth pace stability lint format fuzz replays deps clean help
-include $(shell find build -name '*.d' 2>/dev/null)
