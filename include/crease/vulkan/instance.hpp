// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/owned.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace crease::vulkan::detail {

inline constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

inline bool has_validation_layer() {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::ranges::any_of(layers, [](const VkLayerProperties& layer) {
        return std::strcmp(layer.layerName, validation_layer) == 0;
    });
}

/// A Vulkan 1.1 instance and, where asked for, the validation of all calls below it.
class instance {
public:
    /// @throws error  where there is no Vulkan 1.1, or no validation layer and validation was asked for
    explicit instance(bool validation) {
        auto application = blank<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
        application.apiVersion = VK_API_VERSION_1_1;
        auto info = blank<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
        info.pApplicationInfo = &application;

        auto messenger = blank<VkDebugUtilsMessengerCreateInfoEXT>(
            VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
        messenger.messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        // General messages are the loader's, about the machine's drivers.
        messenger.messageType =
            VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
        messenger.pfnUserCallback = collect;
        messenger.pUserData = &messages_;

        constexpr VkValidationFeatureEnableEXT enabled[] = {
            VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
        auto features = blank<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
        features.enabledValidationFeatureCount = 1;
        features.pEnabledValidationFeatures = enabled;
        features.pNext = &messenger; // from here on, also for the making of the instance

        constexpr const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                              VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
        if (validation) {
            if (!has_validation_layer())
                throw error(std::string("validation was asked for, but there is no layer ") +
                            validation_layer);
            info.enabledLayerCount = 1;
            info.ppEnabledLayerNames = &validation_layer;
            info.enabledExtensionCount = 2;
            info.ppEnabledExtensionNames = extensions;
            info.pNext = &features;
        }
        const VkResult made = vkCreateInstance(&info, nullptr, &handle_);
        if (made == VK_ERROR_INCOMPATIBLE_DRIVER)
            throw error("there is no Vulkan 1.1 driver on this machine");
        check(made, "make a Vulkan instance");
        if (validation)
            listen(messenger);
    }

    ~instance() {
        if (messenger_)
            function<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(
                handle_, messenger_, nullptr);
        vkDestroyInstance(handle_, nullptr);
        for (const std::string& message : messages_) // too late to throw them
            std::fprintf(stderr, "crease::vulkan: %s\n", message.c_str());
    }
    instance(const instance&) = delete;
    instance& operator=(const instance&) = delete;

    VkInstance handle() const { return handle_; }

    /// What validation has said since the last call.
    std::vector<std::string> take_messages() { return std::exchange(messages_, {}); }

    std::vector<VkPhysicalDevice> devices() const {
        std::uint32_t count = 0;
        check(vkEnumeratePhysicalDevices(handle_, &count, nullptr), "list the Vulkan devices");
        std::vector<VkPhysicalDevice> found(count);
        check(vkEnumeratePhysicalDevices(handle_, &count, found.data()), "list the Vulkan devices");
        return found;
    }

private:
    VkInstance handle_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::vector<std::string> messages_;

    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(vkGetInstanceProcAddr(handle_, name));
    }

    void listen(const VkDebugUtilsMessengerCreateInfoEXT& info) {
        function<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT")(handle_, &info,
                                                                                       nullptr, &messenger_);
    }

    static VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                  VkDebugUtilsMessageTypeFlagsEXT,
                                                  const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                  void* messages) {
        static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
        return VK_FALSE;
    }
};

}
