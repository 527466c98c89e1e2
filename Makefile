# The few verbs; the work is in CMakePresets.json. JOBS=N limits how many things are done at once.
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
CLANG_FORMAT ?= clang-format-14
CLANG_TIDY ?= clang-tidy-14

build = cmake --preset $(1) && cmake --build --preset $(1) -j $(JOBS)
sources = git ls-files '*.cpp' '*.hpp'

.PHONY: all demo test stress bench bench-precision fuzz docs gallery install format check-format tidy packages
all: packages
	$(call build,release)

# The paper's example, from the model to its constraint errors.
demo: packages
	$(call build,release) --target mbcc_program mbrt
	@mkdir -p build/demo
	build/release/mbcc examples/artigo5/artigo5.mbd -o build/demo/artigo5.cpp
	$(CXX) -std=c++20 -O2 build/demo/artigo5.cpp -Iruntime/include -Lbuild/release/runtime -lmbrt -o build/demo/artigo5
	build/demo/artigo5

test: all
	ctest --preset release -j $(JOBS)

stress: all
	ctest --preset stress

bench: packages
	$(call build,release) --target mbcc_bench
	build/release/benchmarks/mbcc_bench

# Run time against true error, beside code by hand and what of other people's programs is installed: makes
# docs/precision.md. `cmake/install-packages peers` installs them.
bench-precision: packages
	$(call build,release) --target mbcc_bench_precision
	benchmarks/precision/run build/release docs/precision.md

fuzz: packages
	cmake/install-packages check
	$(call build,fuzz) --target fuzz_front_end
	mkdir -p build/fuzz/corpus
	build/fuzz/tests/fuzz/fuzz_front_end -runs=$(or $(RUNS),1000000) -entropic=0 -dict=tests/fuzz/model.dict build/fuzz/corpus tests/fuzz/seeds examples

# Pages that are made from sources and examples, and committed.
docs: packages
	$(call build,release) --target docs

gallery: packages
	$(call build,release) --target mbcc_program mbrt
	docs/make-gallery build/release/mbcc

install: all
	cmake --install build/release --prefix $(PREFIX)

format:
	$(sources) | xargs $(CLANG_FORMAT) -i

check-format:
	$(sources) | xargs $(CLANG_FORMAT) --dry-run -Werror

# The flags are those of the clang preset: clang-tidy does not know all of g++'s.
tidy: packages
	cmake/install-packages check
	cmake --preset clang
	git ls-files 'compiler/*.cpp' 'runtime/*.cpp' 'cmake/*.cpp' | xargs -P $(JOBS) -n 1 $(CLANG_TIDY) --quiet -p build/clang

packages:
	@cmake/install-packages build
