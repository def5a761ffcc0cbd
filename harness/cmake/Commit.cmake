# assay_commit: the header commit.h with the commit that is built, or "unknown" outside a checkout. Looked up by every
# build, rewritten only when it changes. Run as a script it does the looking up.
if(CMAKE_SCRIPT_MODE_FILE)
  set(commit "unknown")
  execute_process(COMMAND git -C ${ROOT} rev-parse --short=12 HEAD OUTPUT_VARIABLE head RESULT_VARIABLE failed
                  ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    execute_process(COMMAND git -C ${ROOT} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
    set(commit "${head}")
    if(changes)
      string(APPEND commit "+changes")
    endif()
  endif()
  file(CONFIGURE OUTPUT ${OUT} CONTENT "#pragma once\ninline constexpr char kCommit[] = \"${commit}\";\n")
  return()
endif()

add_custom_target(assay_commit_header
  COMMAND ${CMAKE_COMMAND} -DROOT=${CMAKE_SOURCE_DIR} -DOUT=${CMAKE_CURRENT_BINARY_DIR}/commit/commit.h
          -P ${CMAKE_CURRENT_LIST_FILE}
  BYPRODUCTS ${CMAKE_CURRENT_BINARY_DIR}/commit/commit.h COMMENT "" VERBATIM)
add_library(assay_commit INTERFACE)
add_dependencies(assay_commit assay_commit_header)
target_include_directories(assay_commit INTERFACE ${CMAKE_CURRENT_BINARY_DIR}/commit)
