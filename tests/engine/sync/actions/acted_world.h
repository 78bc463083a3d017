#pragma once

#include "tests/engine/sync/connection/session_world.h"

namespace carina
{

using namespace std::chrono_literals;

inline constexpr ObjectId kModel{3};
inline const SimulatedLink::Path kCalm{5ms, 0ms, 0.0, 0.0};
/// Every fault at once: datagrams are lost, doubled and overtake each other.
inline const SimulatedLink::Path kStorm{20ms, 15ms, 0.2, 0.1};
inline constexpr double kRate = 100.0 * 3.14159265358979323846 / 180.0;

inline bool isSame(const EventCpo& a, const EventCpo& b)
{
    return a.epoch == b.epoch && a.action == b.action && a.kind == b.kind && a.start == b.start
           && a.q_AO.coeffs() == b.q_AO.coeffs() && a.p_AO == b.p_AO && a.axis_A == b.axis_A
           && a.rate == b.rate && a.scale == b.scale;
}

/// Sites that share one object, which the first owns to begin with, and follow the facts.
class ActedWorld : public SessionWorld
{
public:
    ActedWorld(std::uint32_t seed, std::size_t sites, const SimulatedLink::Path& path,
               std::vector<SimulatedClock> clocks = {})
        : SessionWorld{seed}
    {
        clocks.resize(sites);
        for (const SimulatedClock& clock : clocks) {
            startClient(addSite(path, clock), "site " + std::to_string(m_followed.size()));
            m_followed.push_back(0);
        }
        SessionWorld::run(2s);
        session.ownership = {self(0), 1};
        host().share(kModel, session.ownership);
        for (std::size_t i = 0; i < sites; ++i)
            site(i).client->share(kModel, session.ownership);
    }
    [[nodiscard]] ParticipantId self(std::size_t i) { return site(i).client->self(); }

    void addLateSite(const SimulatedLink::Path& path)
    {
        startClient(addSite(path), "late");
        m_followed.push_back(0);
        site(m_followed.size() - 1).client->share(kModel, {self(0), 1});
    }
    void restartClient(std::size_t i)
    {
        startClient(i, "site " + std::to_string(i));
        m_followed[i] = 0;
        site(i).client->share(kModel, session.ownership);
    }
    void restartHost()
    {
        crashHost();
        startHost();
        host().share(kModel, session.ownership);
    }
    void run(Duration length, const std::function<void()>& each = {})
    {
        SessionWorld::run(length, 1ms, [&] {
            follow();
            if (each)
                each();
        });
    }
    Result<void> act(std::size_t i, const ObjectAction& action)
    {
        return site(i).client->act(kModel, action, local(i));
    }
    /// Turns the object; as it was when it is refused.
    bool turn(std::size_t i, const Vec3& axis_A = Vec3::UnitZ())
    {
        return act(i, {ActionKind::Rotation, axis_A, kRate, {}}).has_value();
    }
    void takeOver(std::size_t i, std::uint16_t epoch)
    {
        std::string body{"T"};
        body += std::to_string(epoch) + " " + std::to_string(self(i).value);
        propose(i, std::move(body));
    }
    void cut(std::size_t i, bool isCut)
    {
        site(i).toHost.setCut(isCut);
        site(i).fromHost.setCut(isCut);
    }
    [[nodiscard]] const EventCpo* newest(std::size_t i)
    {
        return site(i).client->actions().table().newest(kModel);
    }
    /// Whether every node has this action in force.
    [[nodiscard]] bool allHave(const EventCpo& event)
    {
        bool all = host().actions().table().newest(kModel)
                   && isSame(*host().actions().table().newest(kModel), event);
        for (std::size_t i = 0; i < m_followed.size(); ++i)
            all = all && newest(i) && isSame(*newest(i), event);
        return all;
    }
    [[nodiscard]] std::optional<ShownObject> shown(std::size_t i)
    {
        const auto& mapping = site(i).client->clock().mapping();
        if (!mapping)
            return std::nullopt;
        return site(i).client->actions().shown(kModel, mapping->at(local(i)), local(i), local(i));
    }
    [[nodiscard]] LocalTime local(std::size_t i) { return site(i).clock.at(now()); }

private:
    /// What a node's driver does with facts about ownership.
    void follow()
    {
        host().share(kModel, session.ownership);
        for (std::size_t i = 0; i < m_followed.size(); ++i)
            for (; m_followed[i] < site(i).log.size(); ++m_followed[i])
                if (const auto next = TestSession::handedOver(site(i).log[m_followed[i]].body))
                    site(i).client->share(kModel, *next);
    }

    std::vector<std::size_t> m_followed;
};

} // namespace carina
