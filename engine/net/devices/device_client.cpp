#include "engine/net/devices/device_client.h"

#include "engine/net/devices/device_port.h"
#include "engine/net/devices/serial_ports.h"
#include "engine/tracking/igtl/igtl_client.h"
#include "engine/tracking/ndi/ndi_client.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

NdiClientSettings ndiSettingsOf(const TrackerDescription& description)
{
    NdiClientSettings settings;
    settings.poses = description.poses;
    settings.isSerial = isSerialPort(description.address);
    settings.rates.clear();
    for (const DescribedTool& tool : description.tools)
        settings.tools.push_back({tool.name, tool.definition});
    std::ranges::copy_if(usualSerialRates(), std::back_inserter(settings.rates),
                         [&](int rate) { return rate <= description.fastestRate; });
    return settings;
}

IgtlClientSettings igtlSettingsOf(const TrackerDescription& description)
{
    IgtlClientSettings settings{{}, description.igtlPoses, description.rate_hz};
    for (const DescribedTool& tool : description.tools)
        settings.devices.push_back(tool.device.empty() ? tool.name : tool.device);
    return settings;
}

std::string asText(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class NdiDevice : public DeviceClient
{
public:
    explicit NdiDevice(const TrackerDescription& description) : m_client{ndiSettingsOf(description)}
    {
    }

    void start(LocalTime now, HoldsRate holdsRate) override
    {
        m_client.start(now, std::move(holdsRate));
    }
    void take(std::span<const std::byte> bytes, LocalTime now) override
    {
        m_client.take(bytes, now);
    }
    [[nodiscard]] NdiPortAction advance(LocalTime now) override { return m_client.advance(now); }
    [[nodiscard]] LocalTime nextWake() const override { return m_client.nextWake(); }
    [[nodiscard]] std::vector<DeviceSight> takeSights() override
    {
        std::vector<DeviceSight> sights;
        for (const NdiMeasurement& measured : m_client.takeMeasurements())
            for (std::size_t i = 0; i < measured.tools.size(); ++i)
                if (const auto& tool = measured.tools[i])
                    sights.push_back({i, measured.exposed, tool->X_TO, validityOf(*tool),
                                      tool->error, toolSightOf(*tool)});
        return sights;
    }
    [[nodiscard]] bool isLost() const override { return false; } // it is asked again
    [[nodiscard]] std::string trouble() const override { return m_client.trouble(); }
    [[nodiscard]] bool isSilent() const override { return m_client.isSilent(); }
    [[nodiscard]] std::optional<DeviceFound> found() const override
    {
        const auto found = m_client.found();
        return found ? std::optional{DeviceFound{found->name, found->pluggedIn, {}}} : std::nullopt;
    }
    void leave() override { m_client.leave(); }
    [[nodiscard]] bool hasLeft() const override { return m_client.hasLeft(); }

private:
    NdiClient m_client;
};

class IgtlDevice : public DeviceClient
{
public:
    explicit IgtlDevice(const TrackerDescription& description)
        : m_client{igtlSettingsOf(description)}
    {
    }

    void start(LocalTime now, HoldsRate) override { m_client.start(now); }
    void take(std::span<const std::byte> bytes, LocalTime now) override
    {
        m_client.take(bytes, now);
    }
    [[nodiscard]] NdiPortAction advance(LocalTime now) override
    {
        NdiPortAction action{.bytes = asText(m_client.advance(now))};
        if (m_leaves && !std::exchange(m_hasLeft, true))
            action.bytes += asText(m_client.farewell());
        return action;
    }
    [[nodiscard]] LocalTime nextWake() const override { return m_client.nextWake(); }
    [[nodiscard]] std::vector<DeviceSight> takeSights() override
    {
        std::vector<DeviceSight> sights;
        for (const IgtlSight& sight : m_client.takeSights())
            sights.push_back({sight.tool, sight.exposed, sight.X_TO,
                              sight.X_TO ? Validity::Tracked : Validity::Lost});
        return sights;
    }
    [[nodiscard]] bool isLost() const override { return m_client.isLost(); }
    [[nodiscard]] std::string trouble() const override { return m_client.trouble(); }
    [[nodiscard]] bool isSilent() const override { return m_client.isSilent(); }
    [[nodiscard]] std::optional<DeviceFound> found() const override
    {
        std::vector<std::string> sent = m_client.sentTools();
        return sent.empty() ? std::nullopt : std::optional{DeviceFound{{}, {}, std::move(sent)}};
    }
    void leave() override { m_leaves = true; }
    [[nodiscard]] bool hasLeft() const override { return m_hasLeft; }

private:
    IgtlClient m_client;
    bool m_leaves = false;
    bool m_hasLeft = false;
};

} // namespace

std::unique_ptr<DeviceClient> deviceClient(const TrackerDescription& description)
{
    if (description.kind == TrackerKind::OpenIgtLink)
        return std::make_unique<IgtlDevice>(description);
    return std::make_unique<NdiDevice>(description);
}

} // namespace carina
