# What the benchmark needs beside the program: the allocation counter, the representations once more
# with their reads counted, and other libraries' workers.

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
