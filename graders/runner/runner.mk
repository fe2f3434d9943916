# The runner: what runs in the box beside the student's object, build/runner/<group>/<name>.<flavour>.o.
#
# One relocatable object an exercise, with every name local but main, the allocation shim, and what the
# exercise gives to students (the functions of its own file but run_call), so that a submission can
# call nothing else in it and replace no part of it. Always optimised: it is the same in
# every configuration. Three flavours: plain has the allocation shim; sanitized and checked leave
# allocation to the sanitizers and to valgrind's memcheck.

RUNNER_FLAGS := -std=c17 -D_GNU_SOURCE -I. -O2 -g -fno-sanitize=all $(WARNINGS)
RUNNER_PARTS := $(patsubst %.c,%,$(wildcard graders/runner/*.c graders/wire/*.c))
RUNNER_CALLS := $(patsubst graders/runner/%.c,%,$(wildcard graders/runner/*/*.c))
FLAVOURS := plain sanitized checked
RUNNERS := $(foreach f,$(FLAVOURS),$(RUNNER_CALLS:%=build/runner/%.$(f).o))
SHIM := malloc calloc realloc free aligned_alloc posix_memalign memalign valloc
# What the student's own requests are renamed to (graders/engine/build/wrapped.h).
STUDENT := $(filter-out free,$(SHIM)) reallocarray malloc_usable_size strdup __strdup strndup __strndup \
  wcsdup getline getdelim __getdelim asprintf __asprintf __asprintf_chk vasprintf __vasprintf_chk \
  open_memstream open_wmemstream fmemopen fclose tsearch
RUNNER_NAMES := main $(SHIM:%=__wrap_%) $(STUDENT:%=student_%) __ubsan_default_options

# The call of an exercise, graders/runner/<group>/<name>.c, sees the exercise's own header.
RUNNER_HEADER = $(patsubst graders/runner/%.c,-Iexercises/%,$(filter graders/runner/%,$<))
RUNNER_COMPILE = $(CC) $(RUNNER_FLAGS) $(RUNNER_HEADER) $(DEPENDENCIES) -c $< -o $@

build/runner/plain/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $<)$(RUNNER_COMPILE)
build/runner/sanitized/%.o build/runner/checked/%.o: RUNNER_FLAGS += -DRUNNER_WITHOUT_SHIM
build/runner/sanitized/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $< (sanitized))$(RUNNER_COMPILE)
build/runner/checked/%.o: %.c
	@mkdir -p $(@D)
	$(call SHOW,CC  $< (checked))$(RUNNER_COMPILE)

RUNNER_GIVES = nm -g --defined-only $< | awk '$$3 != "run_call" {print "--keep-global-symbol=" $$3}'
RUNNER_LINK = @mkdir -p $(@D) && ld -r $^ -o $@.tmp && \
  objcopy $(RUNNER_NAMES:%=--keep-global-symbol=%) $$($(RUNNER_GIVES)) $@.tmp $@ && rm $@.tmp
build/runner/%.plain.o: build/runner/plain/graders/runner/%.o $(RUNNER_PARTS:%=build/runner/plain/%.o)
	$(RUNNER_LINK)
build/runner/%.sanitized.o: build/runner/sanitized/graders/runner/%.o $(RUNNER_PARTS:%=build/runner/sanitized/%.o)
	$(RUNNER_LINK)
build/runner/%.checked.o: build/runner/checked/graders/runner/%.o $(RUNNER_PARTS:%=build/runner/checked/%.o)
	$(RUNNER_LINK)

.PHONY: runners
runners: $(RUNNERS)
