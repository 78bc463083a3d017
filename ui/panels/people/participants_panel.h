#pragma once

#include "models/session/conduct_model.h"
#include "models/session/participants_model.h"
#include "models/session/people_model.h"
#include "models/station/stations_model.h"

#include <QMenu>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>

namespace Ui
{
class ParticipantsPanel;
}

namespace carina
{

/// The participants of the session as a table, in which a long name has several lines, and what an
/// instructor may decide about the chosen one: mute, remove, let back in, give the work, where
/// others see them, and, where several stations are open, move to another one. Why work or a place
/// cannot be given is said above the buttons. Besides, the session can be locked.
class ParticipantsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParticipantsPanel(QWidget* parent = nullptr);
    ~ParticipantsPanel() override;

    /// @pre the models outlive the panel.
    void setModel(ParticipantsModel& participants, ConductModel& conduct, StationsModel& stations,
                  PeopleModel& people);

    /// Where the head of this program's participant is, X_AH, from now on, so that others can see
    /// it at another side of the patient. Without it, it is taken to be at the patient's head.
    void setOwnHead(std::function<std::optional<PoseSample>()> head)
    {
        m_ownHead = std::move(head);
    }

    /// Chooses a participant in the table; nothing where there is no such one.
    void choose(ParticipantId participant);

Q_SIGNALS:
    /// Somebody was removed for good, who still knows the code of the role.
    void banned(carina::Role role);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void layTable();
    void fitNames();
    void refresh();
    void offerStations();
    void muteOrNot();
    /// Asks why, and removes; lets a banned participant back in at once.
    void removeOrLetBack();
    void refreshPerson();
    void refreshFigures();
    void refreshColumns();
    [[nodiscard]] std::optional<ParticipantId> chosen() const;

    std::unique_ptr<Ui::ParticipantsPanel> m_ui;
    ParticipantsModel* m_participants = nullptr;
    ConductModel* m_conduct = nullptr;
    StationsModel* m_stations = nullptr;
    QMenu m_moves; ///< a station each
    QTimer m_fitting;
    PeopleModel* m_people = nullptr;
    std::function<std::optional<PoseSample>()> m_ownHead; ///< may be empty
};

} // namespace carina
