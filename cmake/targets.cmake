# How every target of ours is compiled, and the two functions that declare one.

# Fused multiply-adds would make the bits of a generated key depend on the machine, so contraction is off.
add_library(interleaf_options INTERFACE)
target_compile_options(interleaf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # -Wshadow warns, too, where files that are compiled together share a name, -Wdeprecated-declarations inside
  # std::stable_sort. g++ looks for both.
  target_compile_options(interleaf_options INTERFACE -Wno-shadow -Wno-deprecated-declarations)
endif()
target_include_directories(interleaf_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(INTERLEAF_WARNINGS_AS_ERRORS)
  target_compile_options(interleaf_options INTERFACE -Werror)
endif()
if(INTERLEAF_ASSERTIONS)
  target_compile_options(interleaf_options INTERFACE -UNDEBUG -D_GLIBCXX_ASSERTIONS)
endif()
if(INTERLEAF_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(interleaf_options INTERFACE ${sanitizers})
  target_link_options(interleaf_options INTERFACE ${sanitizers})
endif()
if(INTERLEAF_FUZZ)
  set(instruments -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g -O1
    -fprofile-instr-generate -fcoverage-mapping)
  target_compile_options(interleaf_options INTERFACE ${instruments})
  target_link_options(interleaf_options INTERFACE ${instruments})
endif()

# Nearly every file reads these. Only under the sanitizers they are compiled once a target: in the other builds each file
# of src has what it includes itself and nothing else. For one or two files it was measured to take longer than it gains.
function(precompile_headers target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(INTERLEAF_SANITIZE AND count GREATER 2)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string> <string_view> <vector>
      <fmt/core.h> <glm/glm.hpp> ${ARGN})
  endif()
endfunction()

# Several files a compilation: reading the headers takes most of the time. Where that is done, a file may have names of its
# own in common with no other of its target.
function(compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# interleaf_library(NAME SOURCES... LINK targets...): the layer src/NAME as the target interleaf_NAME.
function(interleaf_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;LINK_PRIVATE" ${ARGN})
  add_library(interleaf_${name} STATIC ${arg_SOURCES})
  target_link_libraries(interleaf_${name} PUBLIC interleaf_options ${arg_LINK} PRIVATE ${arg_LINK_PRIVATE})
  # Under the sanitizers the layers that compute are optimized a little; for the others that takes longer than it gains.
  if(INTERLEAF_SANITIZE AND name MATCHES "^(text|hierarchy|family|shapes|fit|io)$")
    target_compile_options(interleaf_${name} PRIVATE -O1)
  elseif(INTERLEAF_SANITIZE)
    target_compile_options(interleaf_${name} PRIVATE -O0)
  endif()
  precompile_headers(interleaf_${name})
  if(INTERLEAF_SANITIZE)
    compile_together(interleaf_${name})
  endif()
endfunction()

# interleaf_test(NAME SOURCES... LINK targets...): a doctest program tests_NAME, run by ctest as NAME.
function(interleaf_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(tests_${name} ${arg_SOURCES})
  target_include_directories(tests_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(tests_${name} PRIVATE interleaf_options ${arg_LINK} tests_main)
  precompile_headers(tests_${name} <doctest/doctest.h>)
  compile_together(tests_${name})
  add_test(NAME ${name} COMMAND tests_${name})
endfunction()
