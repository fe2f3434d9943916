# meshgrade-render, in C++: built where VTK and OpenImageIO are.

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
