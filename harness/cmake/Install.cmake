# cmake --install build --prefix DIR makes a folder that runs anywhere on x86-64 Linux with a glibc no older than the one
# built with and a Vulkan driver: the programs, every library they need beyond glibc, the Vulkan loader, the fixtures.
#
# The programs find lib/ by DT_RPATH, not DT_RUNPATH: only the former also serves libraries of libraries, and dlopen,
# which is how volk finds the loader.
set(programs assay assay_bench)
if(ASSAY_TESTS)
  list(APPEND programs assay_tests)
endif()
foreach(program ${programs})
  set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
  target_link_options(${program} PRIVATE -Wl,--disable-new-dtags)
endforeach()
install(CODE "set(CMAKE_INSTALL_DO_STRIP 1)")
install(TARGETS ${programs} RUNTIME_DEPENDENCY_SET needed RUNTIME DESTINATION bin)
install(RUNTIME_DEPENDENCY_SET needed
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|pthread|rt|resolv|util|mvec|anl)\\.so"
  LIBRARY DESTINATION lib)

file(REAL_PATH ${Vulkan_LIBRARY} loader)
install(FILES ${loader} DESTINATION lib RENAME libvulkan.so.1)
install(DIRECTORY fixtures DESTINATION . OPTIONAL)
install(FILES harness/cmake/bundle.txt DESTINATION . RENAME README.txt)
