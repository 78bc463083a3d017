#include "apps/lab/soak/log_memory.h"

#include "engine/core/expects.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/session_authority.h"

#include <malloc.h>
#include <memory>

namespace carina::lab
{
namespace
{

double heap_bytes()
{
    const struct mallinfo2 heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd);
}

/// As HostDriver has it: the log to be sent, and to be saved anew where its file is lost; the state
/// by what is decided, by what is on disk, and as other threads read it.
struct AtHost {
    std::vector<FactRecord> log;
    std::vector<FactRecord> saved;
    SessionAuthority decided{{}};
    SessionAuthority stored{{}};
    std::shared_ptr<const SessionState> shown;

    void take(const FactRecord& record, const Fact& fact)
    {
        log.push_back(record);
        saved.push_back(record);
        decided.commit(fact);
        stored.commit(fact);
    }
    void show() { shown = std::make_shared<SessionState>(stored.state()); }
};

/// As ClientDriver has it.
struct AtParticipant {
    SessionState state;
    std::shared_ptr<const SessionState> shown;

    void take(const FactRecord& /*record*/, const Fact& fact) { state.apply(fact); }
    void show() { shown = std::make_shared<SessionState>(state); }
};

template <class Holder> double bytesOf(std::span<const FactRecord> log)
{
    const double before = heap_bytes();
    const auto holder = std::make_unique<Holder>();
    for (const FactRecord& record : log) {
        const auto fact = fromRecord(record);
        CARINA_EXPECTS(fact.has_value());
        holder->take(record, *fact);
    }
    holder->show();
    return heap_bytes() - before;
}

} // namespace

LogMemory memoryOf(std::span<const FactRecord> log)
{
    return {bytesOf<AtHost>(log), bytesOf<AtParticipant>(log)};
}

} // namespace carina::lab
