// Buffers, images and arrays of textures: what they are made of.
#include <fmt/format.h>

#include <algorithm>

#include "harness/device/formats.h"
#include "harness/device/internal.h"

namespace assay::device {

namespace {

constexpr VkBufferUsageFlags kBufferUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                            VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                            VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;

// What a view of this format may be used for on this device.
VkImageUsageFlags view_usage(const Device& d, Format f) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(d.physical.handle, info_of(f).vulkan, &properties);
  const VkFormatFeatureFlags has = properties.optimalTilingFeatures;
  VkImageUsageFlags usage = 0;
  if (has & VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
  if (has & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  if (has & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (has & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if (!usage) throw Error(fmt::format("the device has no use for images of format {}", name_of(f)));
  return usage;
}

template <class CreateInfo>
void share(const Device& d, CreateInfo& info) {  // between queue families, where there are two
  if (d.families.size() < 2) return;
  info.sharingMode = VK_SHARING_MODE_CONCURRENT;
  info.queueFamilyIndexCount = static_cast<uint32_t>(d.families.size());
  info.pQueueFamilyIndices = d.families.data();
}

void add_view(Resource& r, Format f, VkImageUsageFlags usage, VkImageViewType type) {
  const VkImageViewUsageCreateInfo only = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_USAGE_CREATE_INFO, .usage = usage};
  const VkImageViewCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                      .pNext = &only,
                                      .image = r.image,
                                      .viewType = type,
                                      .format = info_of(f).vulkan,
                                      .subresourceRange = {aspect_of(f), 0, r.levels, 0, r.layers}};
  VkImageView view = VK_NULL_HANDLE;
  ASSAY_VK(vkCreateImageView(r.device->handle, &info, nullptr, &view));
  r.views[f] = view;
  set_name(*r.device, VK_OBJECT_TYPE_IMAGE_VIEW, view, r.name + " as " + name_of(f));
}

// Makes the image behind `r`, whose format, extent, layers and levels are set.
void create_image(Resource& r, VkImageUsageFlags usage) {
  Device& d = *r.device;
  const VkFormat formats[] = {info_of(r.format).vulkan, info_of(r.second.value_or(r.format)).vulkan};
  const VkImageFormatListCreateInfo list = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO, .viewFormatCount = 2, .pViewFormats = formats};
  const VkImageCreateFlags two = VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT | VK_IMAGE_CREATE_EXTENDED_USAGE_BIT;
  VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                            .pNext = r.second ? &list : nullptr,
                            .flags = r.second ? two : 0,
                            .imageType = VK_IMAGE_TYPE_2D,
                            .format = formats[0],
                            .extent = {r.extent.width, r.extent.height, 1},
                            .mipLevels = r.levels,
                            .arrayLayers = r.layers,
                            .samples = VK_SAMPLE_COUNT_1_BIT,
                            .tiling = VK_IMAGE_TILING_OPTIMAL,
                            .usage = usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
  share(d, info);
  ASSAY_VK(vkCreateImage(d.handle, &info, nullptr, &r.image));
  set_name(d, VK_OBJECT_TYPE_IMAGE, r.image, r.name);
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(d.handle, r.image, &needs);
  r.memory = take_memory(d, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
                         d.unified ? 0 : VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT);
  ASSAY_VK(vkBindImageMemory(d.handle, r.image, r.memory.handle, 0));
  d.aspects[r.image] = aspect_of(r.format);
  d.new_images.push_back(r.image);
}

void require_extent(const std::string& name, Extent e, const Device& d) {
  const uint32_t most = d.physical.properties.limits.maxImageDimension2D;
  if (e.width == 0 || e.height == 0 || e.width > most || e.height > most)
    throw Error(
        fmt::format("{}: an image of {}x{} pixels; this device has 1 to {} a side", name, e.width, e.height, most));
}

}  // namespace

Resource::Resource(std::shared_ptr<Device> d, std::string n, PortKind k)
    : device(std::move(d)), name(std::move(n)), kind(k) {}

Resource::~Resource() {
  if (device->hung) return;
  for (const auto& [format_, view] : views) vkDestroyImageView(device->handle, view, nullptr);
  if (image) {
    std::erase(device->new_images, image);
    device->aspects.erase(image);
    vkDestroyImage(device->handle, image, nullptr);
  }
  vkDestroyBuffer(device->handle, buffer, nullptr);
  give_memory(*device, memory);
}

Owned make_buffer(Device& d, const std::string& name, uint64_t payload) {
  auto r = std::make_shared<Resource>(d.shared_from_this(), name, PortKind::buffer);
  r->payload = payload;
  const uint64_t bytes = bound_bytes(*r);
  if (bytes > d.physical.info.max_buffer_range)
    throw Error(fmt::format("{}: {} bytes with its guard; this device binds {} at most", name, bytes,
                            d.physical.info.max_buffer_range));
  VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = bytes, .usage = kBufferUsage};
  share(d, info);
  ASSAY_VK(vkCreateBuffer(d.handle, &info, nullptr, &r->buffer));
  set_name(d, VK_OBJECT_TYPE_BUFFER, r->buffer, name);
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(d.handle, r->buffer, &needs);
  constexpr VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  r->memory =
      d.unified
          ? take_memory(d, needs, host, VK_MEMORY_PROPERTY_HOST_CACHED_BIT | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0)
          : take_memory(d, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT);
  ASSAY_VK(vkBindBufferMemory(d.handle, r->buffer, r->memory.handle, 0));
  return r;
}

Owned make_image(Device& d, const std::string& name, Format format, std::optional<Format> view, Extent extent) {
  require_extent(name, extent, d);
  if (view && bytes_per_block(*view) != bytes_per_block(format))
    throw std::logic_error(fmt::format("{}: {} and {} differ in size", name, name_of(format), name_of(*view)));
  auto r = std::make_shared<Resource>(d.shared_from_this(), name, PortKind::image);
  r->format = format;
  if (view && *view != format) r->second = view;
  r->extent = extent;
  r->payload = pixel_count(extent) * bytes_per_block(format);
  const VkImageUsageFlags own = view_usage(d, format), other = r->second ? view_usage(d, *r->second) : 0;
  create_image(*r, own | other);
  add_view(*r, format, own, VK_IMAGE_VIEW_TYPE_2D);
  if (r->second) add_view(*r, *r->second, other, VK_IMAGE_VIEW_TYPE_2D);
  return r;
}

Owned make_texture(Device& d, const std::string& name, const Texture& t) {
  require_extent(name, {t.width, t.height}, d);
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(d.physical.handle, info_of(t.format).vulkan, &properties);
  if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
    throw Error(fmt::format("{}: this device does not filter {}", name, name_of(t.format)));
  auto r = std::make_shared<Resource>(d.shared_from_this(), name, PortKind::textures);
  r->format = t.format;
  r->extent = {t.width, t.height};
  r->layers = t.layers;
  r->levels = t.levels;
  r->payload = bytes_of(t);
  if (r->payload != t.bytes.size())
    throw std::logic_error(fmt::format("{}: {}x{}, {} layers, {} levels of {} are {} bytes, {} given", name, t.width,
                                       t.height, t.layers, t.levels, name_of(t.format), r->payload, t.bytes.size()));
  create_image(*r, VK_IMAGE_USAGE_SAMPLED_BIT);
  add_view(*r, t.format, VK_IMAGE_USAGE_SAMPLED_BIT, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
  write(d, *r, t.bytes);
  return r;
}

Owned make_textures(Device& d, const std::string& name, std::span<const Texture> textures, uint64_t slots) {
  if (textures.size() > slots)
    throw Error(fmt::format("{}: {} array textures for {} slots", name, textures.size(), slots));
  auto r = std::make_shared<Resource>(d.shared_from_this(), name, PortKind::textures);
  for (const Texture& t : textures) {
    r->textures.push_back(make_texture(d, fmt::format("{}[{}]", name, r->textures.size()), t));
    r->payload += r->textures.back()->payload;
  }
  if (!d.white) d.white = make_texture(d, "white", {Format::rgba8_unorm, 1, 1, 1, 1, Bytes(4, std::byte{0xff})});
  r->textures.resize(slots, d.white);
  return r;
}

const std::string& name_of(const Resource& r) { return r.name; }
uint64_t payload_bytes(const Resource& r) { return r.payload; }
uint64_t bound_bytes(const Resource& r) {
  return r.kind == PortKind::buffer ? (r.payload + 3) / 4 * 4 + kGuardBytes : r.payload;
}

VkImageView view_of(const Resource& r, Format f) {
  const auto it = r.views.find(f);
  if (it == r.views.end())
    throw std::logic_error(fmt::format("image {} of {} has no view as {}", r.name, name_of(r.format), name_of(f)));
  return it->second;
}

}  // namespace assay::device
