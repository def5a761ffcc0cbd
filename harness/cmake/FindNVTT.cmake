# NVIDIA Texture Tools 2, whose package has no configuration of its own: NVTT::NVTT.
find_path(NVTT_INCLUDE_DIR nvtt/nvtt.h)
find_library(NVTT_LIBRARY nvtt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NVTT REQUIRED_VARS NVTT_LIBRARY NVTT_INCLUDE_DIR)
if(NVTT_FOUND AND NOT TARGET NVTT::NVTT)
  add_library(NVTT::NVTT UNKNOWN IMPORTED)
  set_target_properties(NVTT::NVTT PROPERTIES IMPORTED_LOCATION ${NVTT_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${NVTT_INCLUDE_DIR})
endif()
