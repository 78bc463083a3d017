#pragma once

#include "models/session/conduct_model.h"
#include "models/session/participants_model.h"
#include "models/session/people_model.h"

#include <QWidget>

#include <memory>

namespace Ui
{
class ParticipantsPanel;
}

namespace carina
{

/// The participants of the session as a table, and what an instructor may decide about the chosen
/// one: mute, remove, let back in, give the work, and where others see them. Besides, the session
/// can be locked.
class ParticipantsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParticipantsPanel(QWidget* parent = nullptr);
    ~ParticipantsPanel() override;

    /// @pre the models outlive the panel.
    void setModel(ParticipantsModel& participants, ConductModel& conduct, PeopleModel& people);

Q_SIGNALS:
    /// Somebody was removed for good, who still knows the code of the role.
    void banned(carina::Role role);

private:
    void refresh();
    /// Says of whom the registration cannot be relied on, and why.
    void refreshDoubts();
    void muteOrNot();
    /// Asks why, and removes; lets a banned participant back in at once.
    void removeOrLetBack();
    void refreshPerson();
    [[nodiscard]] std::optional<ParticipantId> chosen() const;

    std::unique_ptr<Ui::ParticipantsPanel> m_ui;
    ParticipantsModel* m_participants = nullptr;
    ConductModel* m_conduct = nullptr;
    PeopleModel* m_people = nullptr;
};

} // namespace carina
