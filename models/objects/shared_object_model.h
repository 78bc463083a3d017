#pragma once

#include "models/session/session_model.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// Which of a station's shared objects a person acts on, whose it is, and how it changes hands.
///
/// Whoever owns an object may hand it on, an instructor may take it or give it to anybody, and a
/// trainee asks for it. What the host would refuse is not offered.
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

    [[nodiscard]] SessionModel& session() const { return m_session; }

    /// Those that actions move, in the order in which they were shared.
    [[nodiscard]] std::vector<Named<ObjectId>> objects() const;
    /// The first until another is chosen; nothing where there is none.
    [[nodiscard]] std::optional<SharedObject> chosen() const;
    void choose(ObjectId object);

    /// Why the person here can do nothing at all, as a sentence; empty where they can.
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] bool isInstructor() const; ///< so may take what is not theirs
    [[nodiscard]] bool isOwn() const;
    /// Whose it is, with a shape: "◆ Tom".
    [[nodiscard]] QString ownerText() const;
    /// Who asks for it: "Tom asks for it"; empty when nobody does.
    [[nodiscard]] QString wishText() const;

    [[nodiscard]] bool isAsking() const;
    [[nodiscard]] bool canAsk() const; ///< or take the wish back, while asking
    [[nodiscard]] bool canTakeOver() const;
    /// To whom the person here may hand it, those who ask for it first; empty where they may not.
    [[nodiscard]] std::vector<Named<ParticipantId>> heirs() const;

    void handOver(ParticipantId heir);

public Q_SLOTS:
    void ask(); ///< or takes the wish back
    void takeOver();

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    [[nodiscard]] const Participant* self(const SessionState& state) const;
    /// What was proposed about the object and is not decided yet.
    [[nodiscard]] std::optional<FactBody> underWay(ObjectId object) const;
    [[nodiscard]] bool mayGive(const SharedObject& object) const;

    SessionModel& m_session;
    StationId m_station;
    std::optional<ObjectId> m_wanted; ///< that was chosen
};

} // namespace carina
