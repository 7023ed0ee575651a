# The compile options of all targets, and the functions that declare libraries and tests.

# Contraction is off, because fused multiply-adds would make the bits of a generated key depend on the
# machine.
add_library(interleaf_options INTERFACE)
set(options -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # Clang's -Wshadow also warns if files that are compiled together share a name, and its
  # -Wdeprecated-declarations warns inside std::stable_sort. g++ checks for both faults.
  list(APPEND options -Wno-shadow -Wno-deprecated-declarations)
endif()
if(INTERLEAF_WARNINGS_AS_ERRORS)
  list(APPEND options -Werror)
endif()
if(INTERLEAF_ASSERTIONS)
  list(APPEND options -UNDEBUG -D_GLIBCXX_ASSERTIONS)
endif()
# Projects that use the installed libraries have their own options and warnings.
target_compile_options(interleaf_options INTERFACE "$<BUILD_INTERFACE:${options}>")
target_compile_features(interleaf_options INTERFACE cxx_std_20)
target_include_directories(interleaf_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/interleaf>)
if(INTERLEAF_SANITIZE)
  # AddressSanitizer finds accesses beyond an object, too; object-size would take a quarter of the time to compile.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=object-size -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_compile_options(interleaf_options INTERFACE ${sanitizers})
  target_link_options(interleaf_options INTERFACE ${sanitizers})
endif()
if(INTERLEAF_FUZZ)
  set(instruments -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g -O1
    -fprofile-instr-generate -fcoverage-mapping)
  target_compile_options(interleaf_options INTERFACE ${instruments})
  target_link_options(interleaf_options INTERFACE ${instruments})
endif()

# compile_together(TARGET KIND [FLAGS]): if INTERLEAF_TOGETHER is on, several files of TARGET form one compilation,
# and it uses the precompiled headers of its KIND: src, programs (with JSON) or tests (with JSON and doctest). They
# are compiled once for all targets with the same FLAGS.
# The internal names of each file must then be unique in the target, and no local name may shadow them (-Wshadow).
# The headers can hide a missing include, which the tests layers.library_includes and layers.own_includes find.
function(compile_together target kind)
  if(NOT INTERLEAF_TOGETHER)
    return()
  endif()
  set(precompiled interleaf_precompiled_${kind}${ARGN})
  if(NOT TARGET ${precompiled})
    set(headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <string>
      <string_view> <vector> <fmt/core.h> <glm/glm.hpp>)
    if(NOT kind STREQUAL src)
      list(APPEND headers <nlohmann/json.hpp>)
    endif()
    if(kind STREQUAL tests)
      list(APPEND headers <doctest/doctest.h>)
    endif()
    set(empty ${PROJECT_BINARY_DIR}/precompiled.cpp)
    file(CONFIGURE OUTPUT ${empty} CONTENT "// Nothing but the precompiled headers.\n")
    add_library(${precompiled} OBJECT ${empty})
    target_link_libraries(${precompiled} PRIVATE
      interleaf_options fmt::fmt glm::glm doctest::doctest nlohmann_json::nlohmann_json)
    target_compile_options(${precompiled} PRIVATE ${ARGN})
    target_precompile_headers(${precompiled} PRIVATE ${headers})
  endif()
  # The headers of fmt depend on a definition that its target provides.
  target_link_libraries(${target} PRIVATE fmt::fmt)
  target_precompile_headers(${target} REUSE_FROM ${precompiled})

  # Each compilation reads all the headers, and clang-tidy checks them, too, so fuller ones take less time together.
  # Under the sanitizers hardly anybody compiles single changes.
  set(batch 16)
  if(INTERLEAF_SANITIZE AND kind STREQUAL src)
    set(batch 72)
  elseif(INTERLEAF_SANITIZE)
    set(batch 24)
  elseif(kind STREQUAL tests)
    set(batch 8)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
endfunction()

# interleaf_library(NAME SOURCES... LINK targets...): the layer src/NAME as the target interleaf_NAME.
function(interleaf_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;LINK_PRIVATE" ${ARGN})
  add_library(interleaf_${name} STATIC ${arg_SOURCES})
  target_link_libraries(interleaf_${name} PUBLIC interleaf_options ${arg_LINK} PRIVATE ${arg_LINK_PRIVATE})
  # The tests run most of their time in the layers that compute. For the other layers, optimizing takes longer than it
  # saves, as does optimizing much under the sanitizers.
  set(optimization)
  if(name MATCHES "^(text|hierarchy|family|shapes|fit|sequence|io)$")
    if(INTERLEAF_SANITIZE)
      set(optimization -O1)
    endif()
  elseif(INTERLEAF_SANITIZE)
    set(optimization -O0)
  elseif(INTERLEAF_TOGETHER)
    set(optimization -O1)
  endif()
  target_compile_options(interleaf_${name} PRIVATE ${optimization})
  compile_together(interleaf_${name} src ${optimization})
endfunction()

# interleaf_test(NAME SOURCES... LINK targets...): a doctest program tests_NAME, run by ctest as NAME.
function(interleaf_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(tests_${name} ${arg_SOURCES})
  target_include_directories(tests_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(tests_${name} PRIVATE interleaf_options ${arg_LINK} tests_main)
  compile_together(tests_${name} tests ${tests_optimization})
  add_test(NAME ${name} COMMAND tests_${name})
endfunction()
