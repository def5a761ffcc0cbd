# assay_headers: every header compiled alone and twice over, so that each includes what it needs. Not part of "all".
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
     ${CMAKE_SOURCE_DIR}/harness/*.h ${CMAKE_SOURCE_DIR}/kernels/*.h ${CMAKE_SOURCE_DIR}/tests/*.h ${CMAKE_SOURCE_DIR}/bench/*.h)
set(alone)
foreach(header ${headers})
  string(MAKE_C_IDENTIFIER "${header}" id)
  set(file ${CMAKE_BINARY_DIR}/headers_alone/${id}.cpp)
  file(CONFIGURE OUTPUT ${file} CONTENT "#include \"${header}\"\n#include \"${header}\"\n")
  list(APPEND alone ${file})
endforeach()
add_library(assay_headers OBJECT EXCLUDE_FROM_ALL ${alone})
target_link_libraries(assay_headers PRIVATE assay_report CLI11::CLI11)
