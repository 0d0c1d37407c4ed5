# The few commands that people need. Everything else is CMake: `cmake --preset release`, `cmake --build build`.
.PHONY: help demo test build asan tsan format clean

help: ## this list
	@grep -E '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 10

demo: build ## install what is missing, build, run tasks/press, draw its pictures under build/
	@tasks/press/demo

test: build ## install what is missing, build, run every test
	@ctest --preset release -j 2

build: ## install what is missing and build
	@scripts/install_dependencies
	@cmake --preset release
	@cmake --build --preset release

asan: ## build and test with the address and undefined-behaviour sanitizers
	@scripts/install_dependencies
	@cmake --preset asan
	@cmake --build --preset asan
	@ctest --preset asan -j 2

tsan: ## build and test with the thread sanitizer
	@scripts/install_dependencies
	@cmake --preset tsan
	@cmake --build --preset tsan
	@ctest --preset tsan -j 2

format: ## format every C++ file
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

clean: ## remove what was built
	@rm -rf build build-asan build-tsan build-fuzz
