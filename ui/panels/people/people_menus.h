#pragma once

#include "models/session/people_model.h"

#include <QMenu>

#include <functional>
#include <optional>

namespace carina
{

/// Through whose eyes a view is: its own camera, or somebody whose head is shared. It is filled
/// each time it opens.
class EyesMenu : public QMenu
{
    Q_OBJECT

public:
    /// @pre people outlives the menu.
    EyesMenu(const PeopleModel& people, const QString& title, QWidget* parent = nullptr);

    /// What is marked as chosen from now on.
    void setChosen(std::optional<ParticipantId> participant) { m_chosen = participant; }

Q_SIGNALS:
    void chosen(std::optional<carina::ParticipantId> participant);

private:
    void fill();
    void add(const QString& text, std::optional<ParticipantId> participant);

    const PeopleModel& m_people;
    std::optional<ParticipantId> m_chosen;
};

/// Where others see a participant.
class PlaceMenu : public QMenu
{
    Q_OBJECT

public:
    using Whom = std::function<std::optional<ParticipantId>()>;
    using Head = std::function<std::optional<PoseSample>()>;

    /// @param ownHead X_AH of this program's participant
    /// @pre people outlives the menu.
    PlaceMenu(PeopleModel& people, Whom whom, Head ownHead, const QString& title,
              QWidget* parent = nullptr);

private:
    /// @param name by which a script finds it
    void add(const QString& text, std::optional<PatientSide> side, const char* name);

    PeopleModel& m_people;
    Whom m_whom;
    Head m_ownHead;
};

/// Who is at work, and to whom this program's participant may give the work. It is filled each time
/// it opens.
class WorkMenu : public QMenu
{
    Q_OBJECT

public:
    /// @pre people outlives the menu.
    WorkMenu(PeopleModel& people, const QString& title, QWidget* parent = nullptr);

private:
    void fill();

    PeopleModel& m_people;
};

} // namespace carina
