// The one file that holds volk's code: the Vulkan loader is opened at run time, nothing links to it.
#define VOLK_IMPLEMENTATION
#include <volk.h>
