#pragma once

#include "engine/anatomy/organ_group.h"
#include "models/objects/object_hand_over.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// Which shared object of a station a person acts on, who owns it, and how its ownership is
/// transferred.
///
/// The owner may hand an object over, an instructor may take it or give it to any participant, and
/// a trainee may ask for it. Groups of organs and the second tube are lifted out of their place,
/// where nobody owns them, and put back. Operations that the host would refuse are not offered.
class SharedObjectModel : public QObject
{
    Q_OBJECT

public:
    template <class Id> struct Named {
        Id id;
        QString name;

        friend bool operator==(const Named&, const Named&) = default;
    };

    /// @pre session outlives this.
    SharedObjectModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// The objects of another station from now on.
    void setStation(StationId station);

    /// Adds what changes hands to a history from now on.
    void setHistory(ChangeHistory& history) { m_handOver.setHistory(history); }

    /// Offers only these groups of organs from now on: those of the patient that is drawn.
    void setGroups(std::vector<OrganGroup> groups);

    [[nodiscard]] SessionModel& session() const { return m_session; }
    [[nodiscard]] StationId station() const { return m_station; }

    /// The objects that can be moved by actions, in the order in which they were shared.
    [[nodiscard]] std::vector<Named<ObjectId>> objects() const;
    /// The first object until another is chosen; std::nullopt if there is none.
    [[nodiscard]] std::optional<SharedObject> chosen() const;
    void choose(ObjectId object);

    /// Why this person cannot act on any object, as a sentence; empty if they can.
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] bool isInstructor() const; ///< who may take objects of others
    [[nodiscard]] bool isOwn() const;
    /// The owner's name after its state mark: "◆ Tom".
    [[nodiscard]] QString ownerText() const;
    /// Who asks for it: "Asking for it: Tom", or that this person's hands are full; empty if
    /// neither.
    [[nodiscard]] QString wishText() const;

    [[nodiscard]] bool isAsking() const;
    [[nodiscard]] bool canAsk() const; ///< or withdraw the request, while isAsking()
    [[nodiscard]] bool canTakeOver() const;
    /// The participants to whom this person may hand it, those who asked for it first; empty if
    /// this person may not.
    [[nodiscard]] std::vector<Named<ParticipantId>> heirs() const;

    void handOver(ParticipantId heir);
    /// Makes an object this person's own. @pre they may have it
    void take(const SharedObject& object);

    [[nodiscard]] bool isLiftable() const; ///< the chosen one
    [[nodiscard]] bool canLift() const;
    [[nodiscard]] bool canPutBack() const;
    /// The history takes it back where it was another's. What was this person's own comes back
    /// with its place, by whoever moves it.
    void putBack(ObjectId object);
    /// What this person may put back at the station: an instructor all that is lifted out, a
    /// trainee what they hold.
    [[nodiscard]] std::vector<ObjectId> toPutBack() const;

public Q_SLOTS:
    void ask(); ///< or withdraws the request
    void takeOver();
    void lift();

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    [[nodiscard]] const Participant* self(const SessionState& state) const;
    /// The fact about the object that was proposed and not yet confirmed.
    [[nodiscard]] std::optional<FactBody> underWay(ObjectId object) const;
    [[nodiscard]] bool mayGive(const SharedObject& object) const;
    [[nodiscard]] bool isOffered(const SharedObject& object) const;
    [[nodiscard]] bool mayPutBack(const SharedObject& object) const;
    [[nodiscard]] QString handsFull(const SharedObject& object) const;

    SessionModel& m_session;
    StationId m_station;
    std::vector<OrganGroup> m_groups{kOrganGroups.begin(), kOrganGroups.end()};
    std::optional<ObjectId> m_wanted; ///< the object chosen last
    ObjectHandOver m_handOver;
};

} // namespace carina
