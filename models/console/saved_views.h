#pragma once

#include "engine/geometry/rigid_transform.h"
#include "models/session/change_history.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <cstddef>
#include <vector>

namespace carina
{

class KeptConsole;

/// Where a camera stood, in the anatomy frame A, metres: a view of the same side of the body
/// however the patient lies.
struct SavedView {
    QString name;
    Vec3 p_A_eye = Vec3::Zero();
    Vec3 p_A_target = Vec3::Zero();
    Vec3 up_A = Vec3::UnitZ();

    friend bool operator==(const SavedView&, const SavedView&) = default;
};

/// Whether a camera can stand there: finite, not in its target, up not along the line to it.
[[nodiscard]] bool isPossible(const SavedView& view);

/// The views that an instructor saved by name, by the order of saving; remembered.
class SavedViews : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 20;
    static constexpr int kLongestName = 40;

    /// @pre kept outlives this.
    explicit SavedViews(KeptConsole& kept, QObject* parent = nullptr);

    /// Adds what is deleted or saved over to a history from now on. Where it cannot come back, the
    /// history says why.
    void setHistory(ChangeHistory& history) { m_history = &history; }

    [[nodiscard]] const std::vector<SavedView>& all() const { return m_views; }
    /// One sentence: why a view cannot be saved under this name; empty if it can.
    [[nodiscard]] QString faultOf(const QString& name) const;
    /// Under the name without spaces around it; one of the same name is replaced.
    /// @pre faultOf its name is empty, isPossible(view)
    void save(SavedView view);
    void remove(const QString& name);

Q_SIGNALS:
    void changed();

private:
    void bringBack(const SavedView& view, std::size_t place);
    void replaceBack(const SavedView& view, const SavedView& saved);
    void refuse(const QString& why);
    void keep();

    KeptConsole& m_kept;
    QPointer<ChangeHistory> m_history;
    std::vector<SavedView> m_views;
};

} // namespace carina
