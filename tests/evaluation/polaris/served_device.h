#pragma once

#include "evaluation/polaris/polaris_line.h"

#include <atomic>
#include <thread>

namespace carina
{

/// A simulated Polaris, served on a thread until it is destroyed.
class ServedDevice
{
public:
    ServedDevice(PolarisLine line, PolarisDevice::Settings settings, PolarisDevice::PoseOf poseOf)
        : m_device{std::move(settings), std::move(poseOf)},
          m_thread{[this, line = std::move(line)]() mutable {
              static_cast<void>(line.serve(m_device, [this](LocalTime) {
                  m_isTracking = m_device.isTracking();
                  return !m_ends;
              }));
          }}
    {
    }
    ~ServedDevice()
    {
        m_ends = true;
        m_thread.join();
    }
    ServedDevice(const ServedDevice&) = delete;
    ServedDevice& operator=(const ServedDevice&) = delete;

    /// A hundredth of a second ago.
    [[nodiscard]] bool isTracking() const { return m_isTracking; }

private:
    PolarisDevice m_device;
    std::atomic<bool> m_isTracking = false;
    std::atomic<bool> m_ends = false;
    std::thread m_thread; // last: it uses the others
};

} // namespace carina
