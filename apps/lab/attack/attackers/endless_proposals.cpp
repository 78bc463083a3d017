#include "apps/lab/attack/attackers/endless_proposals.h"

#include "apps/lab/attack/attackers/participating.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/session/facts/fact_codec.h"

#include <algorithm>
#include <ranges>

namespace carina::lab
{
namespace
{

/// Proposes as much as fits into some datagrams.
class Proposing : public Participating
{
public:
    Proposing(const Target& target, Role role) : Participating{target, role}
    {
        attendee().intruder().onRecord([this](const WireRecord& record) {
            const bool isRefusal = std::holds_alternative<ProposalRefused>(record)
                                   || std::holds_alternative<HelloRefused>(record);
            m_refused += isRefusal ? 1 : 0;
        });
    }

    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        static_cast<void>(length);
        return {atLeast(kLeastRefused, "proposals and Hellos refused, and paths that were ended",
                        m_refused + intruder().ended())};
    }

protected:
    void flood(Intruder& intruder) override
    {
        std::vector<WireRecord> proposals;
        for (int i = 0; i < kProposals; ++i)
            proposals.emplace_back(
                toRecord(Proposal{anyId(), kNobody, intruder.station(), body(intruder)}));
        intruder.send(proposals);
    }

private:
    static constexpr int kProposals = 100;
    /// Who floods is put out within a turn of the host, with few answers, and tries again.
    static constexpr double kLeastRefused = 5.0;

    std::int64_t m_refused = 0;

    /// @pre it was welcomed
    [[nodiscard]] virtual FactBody body(const Intruder& intruder) = 0;
};

class Leaving : public Proposing
{
public:
    explicit Leaving(const Target& target) : Proposing{target, Role::Observer} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        return fact::ParticipantLeft{intruder.welcome()->participant};
    }
};

/// Shares ever more tubes, and hands them over to the host in turn, to make room for the next.
class Sharing : public Proposing
{
public:
    explicit Sharing(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    static constexpr ParticipantId kHost{0};

    FactBody body(const Intruder& intruder) override
    {
        const ParticipantId self = intruder.welcome()->participant;
        if (anyNumber() % 2 == 0)
            if (const auto shared = newestOf(intruder, self))
                return fact::ObjectHandedOver{*shared, kHost, 1};
        return fact::ObjectShared{ObjectId{}, self, ObjectKind::Tube, std::to_string(anyNumber())};
    }
    static std::optional<ObjectId> newestOf(const Intruder& intruder, ParticipantId self)
    {
        for (const FactRecord& record : intruder.facts() | std::views::reverse) {
            const auto fact = fromRecord(record);
            const auto* shared = fact ? std::get_if<fact::ObjectShared>(&fact->body) : nullptr;
            if (shared && shared->owner == self)
                return shared->object;
        }
        return std::nullopt;
    }
};

class Breathing : public Proposing
{
public:
    explicit Breathing(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        return fact::ManikinBreathed{intruder.sessionNow()};
    }
};

/// Chooses the place where it is, and states the registration that it has, without end.
class Repeating : public Proposing
{
public:
    explicit Repeating(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        if (anyNumber() % 2 == 0)
            return fact::RegistrationStated{{RegistrationState::Good, {}, millimetres(1.0)}};
        return fact::PlaceChosen{intruder.welcome()->participant, {}};
    }
};

/// Decides without end what an instructor may decide about the patient, a tenth more often than
/// the host takes: who floods it is soon put out.
class Instructing : public Participating
{
public:
    explicit Instructing(const Target& target) : Participating{target, Role::Instructor} {}

    [[nodiscard]] std::int64_t patientsLaid() const override
    {
        if (!intruder().welcome())
            return 0;
        const ParticipantId self = intruder().welcome()->participant;
        return std::ranges::count_if(intruder().facts(), [self](const FactRecord& record) {
            const auto fact = fromRecord(record);
            return record.author == self && fact
                   && std::holds_alternative<fact::AnatomyChosen>(fact->body);
        });
    }

protected:
    void flood(Intruder& intruder) override
    {
        const LocalTime now = monotonicNow();
        m_next = std::max(m_next, now - kMostBehind);
        std::vector<WireRecord> proposals;
        for (; m_next < now; m_next += kInterval)
            proposals.emplace_back(
                toRecord(Proposal{anyId(), kNobody, intruder.station(), body()}));
        if (!proposals.empty())
            intruder.send(proposals);
    }

private:
    static constexpr Duration kInterval = std::chrono::microseconds{9091}; ///< 110 a second
    static constexpr Duration kMostBehind = std::chrono::milliseconds{100};

    FactBody body()
    {
        const double share = 0.01 * double(anyNumber() % 100);
        switch (anyNumber() % 5) {
        case 0:
            return chosen(anyNumber() % 2 == 0 ? BuiltinPatient::Adult
                                               : BuiltinPatient::TwelveYears);
        case 1:
            return fact::BreathingRateSet{perMinute(10.0 + 30.0 * share)};
        case 2:
            return fact::LungConditionsSet{{{ConditionKind::Asthma, share, ConditionSide::Both}}};
        case 3:
            return fact::AirwayEventsSet{{{AirwayEventKind::TongueOedema, share}},
                                         std::chrono::seconds{1}};
        default:
            return fact::TidalVolumeSet{millilitres(200.0 + 300.0 * share)};
        }
    }
    static FactBody chosen(BuiltinPatient patient)
    {
        const PatientParameters parameters = parametersOf(patient);
        return fact::AnatomyChosen{madeHash(parameters), nameOf(parameters)};
    }

    LocalTime m_next{};
};

/// Gives observers a new code without end.
class NewCodes : public Proposing
{
public:
    explicit NewCodes(const Target& target) : Proposing{target, Role::Instructor} {}

private:
    FactBody body(const Intruder&) override { return fact::RoleCodeChanged{Role::Observer}; }
};

} // namespace

std::unique_ptr<Attack> beginLeaving(const Target& target)
{
    return std::make_unique<Leaving>(target);
}

std::unique_ptr<Attack> beginSharing(const Target& target)
{
    return std::make_unique<Sharing>(target);
}

std::unique_ptr<Attack> beginBreathing(const Target& target)
{
    return std::make_unique<Breathing>(target);
}

std::unique_ptr<Attack> beginRepeating(const Target& target)
{
    return std::make_unique<Repeating>(target);
}

std::unique_ptr<Attack> beginInstructing(const Target& target)
{
    return std::make_unique<Instructing>(target);
}

std::unique_ptr<Attack> beginNewCodes(const Target& target)
{
    return std::make_unique<NewCodes>(target);
}

} // namespace carina::lab
