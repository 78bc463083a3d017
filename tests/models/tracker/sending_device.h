#pragma once

#include "models/tracker/tracker_choice.h"
#include "tests/engine/net/devices/igtl_offers.h"

namespace carina::test
{

/// A device that a test has send one tool: a server of OpenIGTLink.
struct SendingDevice {
    std::unique_ptr<IgtlServer> server = IgtlServer::listen({"127.0.0.1", 0}).value();
    std::string name; ///< of the tool
    RigidTransform X_DO;
    int given = 0;

    /// Once more. It stamps 16 times a second.
    void give()
    {
        auto offer = std::make_shared<IgtlOffer>();
        offer->stamp = std::uint64_t(++given) << 28U;
        offer->tools = {{name, X_DO, true}};
        offer->landmarks = std::make_shared<const IgtlPoints>();
        server->give(std::move(offer));
    }

    [[nodiscard]] std::string address() const
    {
        return "127.0.0.1:" + std::to_string(server->port());
    }

    [[nodiscard]] PlacedDescription described(ToolRole role, const DevicePlace& place = {}) const
    {
        TrackerDescription description;
        description.kind = TrackerKind::OpenIgtLink;
        description.address = address();
        description.tools.push_back({name, role, {}, name});
        return {std::move(description), place};
    }
};

} // namespace carina::test
