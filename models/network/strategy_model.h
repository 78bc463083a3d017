#pragma once

#include "models/session/session_model.h"

#include <vector>

namespace carina
{

/// How the session keeps acted-on objects alike, which a researcher may change. Lives on the GUI
/// thread.
class StrategyModel : public QObject
{
    Q_OBJECT

public:
    struct Entry {
        StrategyKind kind;
        QString name;
        QString sentence; ///< what it does
    };

    /// @pre session outlives this.
    explicit StrategyModel(SessionModel& session, QObject* parent = nullptr);

    /// All there are, the usual one first.
    [[nodiscard]] static std::vector<Entry> entries();
    [[nodiscard]] StrategyChoice chosen() const;
    /// "Session clock"
    [[nodiscard]] QString chosenName() const;
    void choose(const StrategyChoice& choice);

Q_SIGNALS:
    /// Another strategy may be chosen.
    void changed();

private:
    SessionModel& m_session;
};

} // namespace carina
