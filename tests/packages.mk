# The Debian packages that goals need, and how a goal that lacks some installs them first.
CORE_PACKAGES := gcc libc6-dev make binutils pkg-config libjansson-dev libsqlite3-dev libarchive-dev \
  libseccomp-dev nettle-dev valgrind
PICTURE_PACKAGES := g++ libvtk9-dev libopenimageio-dev libegl-dev libegl1 libgl1-mesa-dri fonts-open-sans \
  libjs-three
DEMO_PACKAGES := zip
TEST_PACKAGES := libcmocka-dev chromium python3 procps
PEER_PACKAGES := g++ libopenmesh-dev libcgal-dev libmeshoptimizer-dev libassimp-dev libvtk9-dev
LINT_PACKAGES := clang-format clang-tidy cppcheck python3
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
SELF_PREPARING := deps demo demo-all test unit validate lint format fuzz stability bench-grader growth pace
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
