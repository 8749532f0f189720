# How every target of burin is compiled. Nothing here reaches a consumer.
add_library(burin_options INTERFACE)
target_compile_features(burin_options INTERFACE cxx_std_20)
# No contraction: the same bits whatever the machine and the optimisation level.
target_compile_options(burin_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
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
