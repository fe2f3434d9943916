# Tests, and the programs that check the grader's decisions.

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

# ---------------------------------------------------------------- decisions of the grader
# Checked on real solutions; see bench/measure/README.md.
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
