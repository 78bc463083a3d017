#pragma once

#include "models/airway/airway_event_model.h"
#include "models/airway/airway_groups.h"

#include <QWidget>

#include <vector>

class QPushButton;

namespace carina
{

/// Chooses which events of the airway are in sight: those of one group, or all. The heading of a
/// group says how many of its events are set, whether or not they are in sight: "Larynx · 2"; and
/// "Larynx ▲ 2" where the patient does not show some of these.
class AirwayGroupBar : public QWidget
{
    Q_OBJECT

public:
    explicit AirwayGroupBar(QWidget* parent = nullptr);

    /// @pre the model outlives the bar.
    void setModel(const AirwayEventModel& model);

    /// Gives a widget the place behind the last heading, which leaves it free.
    void addBehind(QWidget& widget);

    /// The name of the group that is chosen; kAll of all of them. The first group at first.
    [[nodiscard]] const QByteArray& chosen() const { return m_chosen; }
    /// The heading of what is chosen.
    [[nodiscard]] QPushButton* heading() const { return m_heading; }
    /// Nothing where no group is called so.
    void choose(const QByteArray& name);
    /// Whether events of this kind are to be in sight.
    [[nodiscard]] bool shows(AirwayEventKind kind) const;

    static constexpr const char* kAll = "all";

Q_SIGNALS:
    /// A person chose by a heading.
    void chosenByHand();

private:
    QPushButton* addHeading(const QByteArray& name, int place);
    void refresh();
    void refreshHeading(std::size_t place);
    [[nodiscard]] AirwayEvents setOf(const AirwayGroup& group) const;

    const AirwayEventModel* m_model = nullptr;
    QByteArray m_chosen;
    std::vector<QPushButton*> m_headings; ///< in the order of the groups
    QPushButton* m_all = nullptr;
    QPushButton* m_heading = nullptr; ///< one of these
};

} // namespace carina
