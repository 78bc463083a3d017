// Any bytes in place of a fact: refused, or read and written back to the very same bytes; and what
// the rules of a session permit then becomes part of its state.

#include "engine/core/expects.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/session_authority.h"
#include "tests/engine/session/facts/sample_session.h"

#include <algorithm>

namespace
{

using namespace carina;

/// What the first byte chooses the author of: the host, or one of each role, or a newcomer.
constexpr ParticipantId kAuthors[] = {test::kSampleHost, test::kSampleInstructor,
                                      test::kSampleTrainee, test::kSampleObserver, kNobody};
constexpr StationId kStations[] = {test::kSampleStation, StationId{7}, kAllStations, kNoStation};
constexpr Duration kNear = std::chrono::milliseconds{1};

void propose(const FactBody& body, ParticipantId author, StationId station)
{
    static const SessionAuthority sample{test::sampleSession().log()};
    SessionAuthority authority = sample;
    const SessionTime now = test::atSeconds(100.0);
    const auto fact = authority.judge({ProposalId{5}, author, station, body}, now, kNear);
    if (!fact)
        return;
    CARINA_EXPECTS(fact->effect >= now);
    authority.commit(*fact);
    CARINA_EXPECTS(authority.state().lastApplied() == fact->number);
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const auto bytes = std::as_bytes(std::span{data + 1, size - 1});
    const auto body = decodeBody(bytes);
    if (!body)
        return 0;
    CARINA_EXPECTS(std::ranges::equal(encodeBody(*body), bytes));
    const bool isPossible = checkBody(*body).has_value();
    const std::uint8_t chosen = data[0];
    if (isPossible)
        propose(*body, kAuthors[chosen % std::size(kAuthors)],
                kStations[chosen / std::size(kAuthors) % std::size(kStations)]);
    return 0;
}
