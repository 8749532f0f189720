# How every target of burin is compiled. Nothing here reaches a consumer.
add_library(burin_options INTERFACE)
target_compile_features(burin_options INTERFACE cxx_std_20)
# No contraction: the same bits whatever the machine and the optimisation level.
target_compile_options(burin_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Nobody replaces a function of a library by one of the same name: it may be inlined where it is, as clang does.
  target_compile_options(burin_options INTERFACE -fno-semantic-interposition)
  # g++ 12 warns falsely about "text" + std::string (its bug 105651) and, at -O3, about moving a std::variant (105562).
  target_compile_options(burin_options INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(BURIN_WERROR)
  target_compile_options(burin_options INTERFACE -Werror)
endif()
if(BURIN_SANITIZE)
  target_compile_options(burin_options INTERFACE -fsanitize=${BURIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(burin_options INTERFACE -fsanitize=${BURIN_SANITIZE})
endif()

# burin_precompile(target [HEADER...]): the headers nearly every file includes, parsed once. For builds from nothing; the
# release build goes without, and so finds the include that a file forgot.
option(BURIN_PRECOMPILE "Precompile the standard headers: a build from nothing takes a quarter less time" OFF)
function(burin_precompile target)
  if(BURIN_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory>
                              <optional> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> ${ARGN})
  endif()
endfunction()
if(BURIN_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 forgets that what it precompiled are the system's headers, whose warnings nobody sees otherwise.
  target_compile_options(burin_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
