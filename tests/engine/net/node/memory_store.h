#pragma once

#include "engine/session/facts/fact_store.h"

#include <QTemporaryDir>

#include <memory>
#include <utility>

namespace carina
{

/// A disk that outlives the stores on it, for a test on one thread at a time.
struct MemoryDisk {
    std::vector<FactRecord> facts;
    std::optional<ClockAnchor> anchor;
    std::vector<EventCpo> actions;
    bool full = false;                          ///< nothing can be written
    std::optional<std::filesystem::path> moved; ///< what keepWhole tells next
    QTemporaryDir folder;                       ///< for what lies beside the store
};

/// A FactStore on a MemoryDisk.
class MemoryStore : public FactStore
{
public:
    explicit MemoryStore(MemoryDisk& disk) : m_disk{disk} {}

    Result<std::vector<FactRecord>> load() override { return m_disk.facts; }
    Result<void> append(std::span<const FactRecord> facts) override
    {
        if (m_disk.full)
            return fail(Errc::StoreFailed, "disk full");
        m_disk.facts.insert(m_disk.facts.end(), facts.begin(), facts.end());
        return {};
    }
    Result<std::optional<ClockAnchor>> clockAnchor() override { return m_disk.anchor; }
    Result<void> setClockAnchor(const ClockAnchor& anchor) override
    {
        m_disk.anchor = anchor;
        return {};
    }

    Result<std::vector<EventCpo>> actions() override { return m_disk.actions; }
    Result<void> keepActions(std::span<const EventCpo> events) override
    {
        if (m_disk.full)
            return fail(Errc::StoreFailed, "disk full");
        for (const EventCpo& event : events) {
            std::erase_if(m_disk.actions,
                          [&](const auto& kept) { return kept.object == event.object; });
            m_disk.actions.push_back(event);
        }
        return {};
    }
    Result<std::optional<std::filesystem::path>> keepWhole() override
    {
        if (m_disk.full)
            return fail(Errc::StoreFailed, "disk full");
        return std::exchange(m_disk.moved, std::nullopt);
    }

private:
    MemoryDisk& m_disk;
};

} // namespace carina
