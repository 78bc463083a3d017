#pragma once

#include "models/session/session_model.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// Which shared object of a station a person acts on, who owns it, and how its ownership is
/// transferred.
///
/// The owner may hand an object over, an instructor may take it or give it to any participant, and
/// a trainee may ask for it. Operations that the host would refuse are not offered.
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

    [[nodiscard]] SessionModel& session() const { return m_session; }

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
    /// Who asks for it: "Asking for it: Tom"; empty if nobody does.
    [[nodiscard]] QString wishText() const;

    [[nodiscard]] bool isAsking() const;
    [[nodiscard]] bool canAsk() const; ///< or withdraw the request, while isAsking()
    [[nodiscard]] bool canTakeOver() const;
    /// The participants to whom this person may hand it, those who asked for it first; empty if
    /// this person may not.
    [[nodiscard]] std::vector<Named<ParticipantId>> heirs() const;

    void handOver(ParticipantId heir);

public Q_SLOTS:
    void ask(); ///< or withdraws the request
    void takeOver();

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    [[nodiscard]] const Participant* self(const SessionState& state) const;
    /// The fact about the object that was proposed and not yet confirmed.
    [[nodiscard]] std::optional<FactBody> underWay(ObjectId object) const;
    [[nodiscard]] bool mayGive(const SharedObject& object) const;

    SessionModel& m_session;
    StationId m_station;
    std::optional<ObjectId> m_wanted; ///< the object chosen last
};

} // namespace carina
