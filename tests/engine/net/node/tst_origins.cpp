#include "engine/net/node/origins.h"
#include "engine/session/participant_limits.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::origins_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SourcePrefix kHere{1};
constexpr SourcePrefix kElsewhere{2};
constexpr SessionTime kLater{600s};

/// A session of which only the comings and goings are known.
class Gate
{
public:
    bool comesIn(ParticipantId id, Role role, const SourcePrefix& from, SessionTime now)
    {
        const Origins::Comer comer{id, role, from};
        if (!origins.mayComeIn(comer, m_state, now))
            return false;
        apply(now, fact::ParticipantJoined{id, role, "Guest " + std::to_string(id.value)});
        origins.cameIn(comer);
        return true;
    }
    void leaves(ParticipantId id, SessionTime now) { apply(now, fact::ParticipantLeft{id}); }

    [[nodiscard]] const SessionState& state() const { return m_state; }

    Origins origins;

private:
    void apply(SessionTime now, FactBody body)
    {
        const FactNumber number{m_state.lastApplied().value + 1};
        m_state.apply(
            {number, ProposalId{number.value}, kNobody, kNoStation, now, now, std::move(body)});
    }

    SessionState m_state;
};

ParticipantId guest(std::size_t number) { return ParticipantId{std::uint16_t(number)}; }

/// As many as may be present from one address, with the numbers from 1 on.
std::size_t fill(Gate& gate, Role role)
{
    std::size_t last = 0;
    while (gate.comesIn(guest(last + 1), role, kHere, SessionTime{}))
        ++last;
    return last;
}

} // namespace

/// How many come in from one address.
class TestOrigins : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlySoManyArePresentFromOneAddress()
    {
        Gate gate;
        const std::size_t most = fill(gate, Role::Trainee);
        QCOMPARE(most, mostPresentFrom(Role::Trainee));
        QVERIFY(gate.comesIn(guest(most + 1), Role::Observer, kHere, kLater)); // in another role
        QVERIFY(gate.comesIn(guest(most + 2), Role::Trainee, kElsewhere, kLater));
        QVERIFY(gate.comesIn(guest(1), Role::Trainee, kHere, kLater)); // who is there comes again
        QVERIFY(!gate.comesIn(guest(most + 3), Role::Trainee, kHere, kLater));
    }

    /// Who left, and whoever came in instead, would together fill all places.
    void placeThatIsKeptCounts()
    {
        Gate gate;
        const std::size_t most = fill(gate, Role::Observer);
        gate.leaves(guest(1), kLater);
        QVERIFY(!gate.comesIn(guest(most + 1), Role::Observer, kHere, kLater + 1s));
        QVERIFY(gate.comesIn(guest(1), Role::Observer, kHere, kLater + 1s));
    }

    void whosePlaceIsNotKeptAnyMoreFindsNone()
    {
        Gate gate;
        const std::size_t most = fill(gate, Role::Observer);
        gate.leaves(guest(1), kLater);
        const SessionTime over = kLater + kPlaceKept;
        QVERIFY(gate.comesIn(guest(most + 1), Role::Observer, kHere, over));
        QVERIFY(!gate.comesIn(guest(1), Role::Observer, kHere, over));
        QVERIFY(gate.comesIn(guest(1), Role::Observer, kElsewhere, over));
    }

    /// Else newcomers, and those who were there before, would together fill all places.
    void placeThatWasKeptOverARestartCountsOnceItsOwnerIsBack()
    {
        Gate gate;
        const std::size_t most = fill(gate, Role::Observer);
        gate.origins = {};
        QVERIFY(gate.comesIn(guest(most + 1), Role::Observer, kHere, kLater));
        std::size_t back = 0;
        for (std::size_t i = 1; i <= most; ++i)
            back += gate.comesIn(guest(i), Role::Observer, kHere, kLater) ? 1 : 0;
        QCOMPARE(back, most - 1);
    }

    void oneAddressBringsOnlySoManyNames()
    {
        Gate gate;
        const std::size_t most = mostNamesFrom(Role::Instructor);
        for (std::size_t i = 1; i <= most; ++i) {
            QVERIFY(gate.comesIn(guest(i), Role::Instructor, kHere, kLater));
            gate.leaves(guest(i), kLater); // at once, so that no place is kept
        }
        QVERIFY(!gate.comesIn(guest(most + 1), Role::Instructor, kHere, kLater));
        QVERIFY(gate.comesIn(guest(1), Role::Instructor, kHere, kLater)); // not a new one
        QVERIFY(gate.comesIn(guest(most + 2), Role::Instructor, kElsewhere, kLater));
    }

    void whoseJoiningWasNotStoredBroughtNoName()
    {
        Origins origins;
        const SessionState empty;
        for (std::size_t i = 1; i <= 2 * mostNamesFrom(Role::Observer); ++i) {
            const Origins::Comer comer{guest(i), Role::Observer, kHere};
            QVERIFY(origins.mayComeIn(comer, empty, kLater));
            origins.cameIn(comer);
            origins.forgetOthersThan(empty);
        }
    }
};

CARINA_TEST(TestOrigins)

} // namespace carina::origins_test

#include "tst_origins.moc"
