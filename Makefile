# The few commands that people need. Everything else is CMake: `cmake --preset release`, `cmake --build build`.
.PHONY: help demo check test build panel package docs lint asan tsan format clean

# six for two processors: a test takes two, one that mostly waits takes one: docs/how-to/testing.md
slots := $(shell expr 3 '*' $$(nproc))

help: ## this list
	@grep -E '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 10

demo: ## install and build what tasks/press needs, run it, draw its pictures under build/
	@scripts/phase "install packages" scripts/install_dependencies demo
	@scripts/phase "configure" cmake --preset demo
	@scripts/phase "build" cmake --build --preset demo
	@scripts/phase "run press" tasks/press/demo

check: ## install what is missing, build and run the fast tests
	@scripts/install_dependencies
	@cmake --preset release
	@cmake --build --preset fast
	@ctest --preset release -L fast -j $(slots)

test: build ## install what is missing, build, run every test
	@ctest --preset release -j $(slots)

build: ## install what is missing and build
	@scripts/install_dependencies
	@cmake --preset release
	@cmake --build --preset release

panel: ## install what is missing and build the operator's panel for browsers
	@scripts/install_dependencies
	@cmake --preset release
	@cmake --build --preset release --target mrroc_panel panel_page

package: build ## make the Debian packages build/*.deb
	@cd build && cpack -G DEB

docs: ## make the reference of the public headers: build/docs/html/index.html
	@scripts/install_dependencies
	@cmake --preset release
	@cmake --build --preset release --target docs

lint: ## compile every source by itself and check it with clang-tidy
	@scripts/install_dependencies
	@scripts/lint

asan: ## build and test with the address and undefined-behaviour sanitizers
	@scripts/install_dependencies
	@cmake --preset asan
	@cmake --build --preset asan
	@ctest --preset asan -j $(slots)

tsan: ## build and test with the thread sanitizer
	@scripts/install_dependencies
	@cmake --preset tsan
	@cmake --build --preset tsan
	@ctest --preset tsan -j $(slots)

format: ## format every C++ file
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

clean: ## remove what was built
	@rm -rf build build-lint build-asan build-tsan build-fuzz
