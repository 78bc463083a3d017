#pragma once

#include "models/patient/planned_patient.h"
#include "models/session/readiness.h"
#include "models/session/session_plan.h"
#include "models/session/stored_sessions.h"

#include <QWidget>

#include <functional>
#include <optional>

class QButtonGroup;
class QComboBox;
class QFormLayout;
class QGridLayout;
class QGroupBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace carina
{

class MessageLine;
class PatientPicture;

/// Where the console begins: a new session with its patient, or an earlier one; who can join; and
/// what is ready. It decides nothing: it says what a person wants.
class StartPage : public QWidget
{
    Q_OBJECT

public:
    /// How things stand for a site and a patient, who may be null.
    using Readiness =
        std::function<std::vector<ReadyLine>(const QString& site, const PatientModel* patient)>;

    /// @param begin what is filled in at first @pre all outlive the page.
    StartPage(StoredSessionsModel& stored, PlannedPatient& patient, const SessionPlan& begin,
              Readiness readiness);

    /// As filled in.
    [[nodiscard]] SessionPlan plan() const;
    /// Shows why what was wanted could not be done; empty: nothing.
    void warn(const QString& problem);
    /// While a session is made, nothing else can be wanted.
    void setBusy(bool busy);

    /// Whoever comes back may have changed something elsewhere.
    bool event(QEvent* event) override;

Q_SIGNALS:
    void beginWanted(const carina::SessionPlan& plan);
    /// To go on with the session in a file.
    void resumeWanted(const QString& file, carina::SessionReach reach);
    /// To read the surfaces in a folder; PlannedPatient has the result then.
    void importWanted(const QString& folder);

private:
    [[nodiscard]] QGroupBox* newSession(const SessionPlan& begin);
    [[nodiscard]] QGroupBox* earlierSessions();
    [[nodiscard]] QGroupBox* whoCanJoin(SessionReach reach);
    [[nodiscard]] QGroupBox* whatIsReady();
    void addPatient(QFormLayout& form, const SessionPlan& begin);
    void addSite(QFormLayout& form, const QString& site);
    void choosePatient();
    void chooseFolder();
    void chooseSite();
    [[nodiscard]] QString patientWords() const;
    [[nodiscard]] SessionReach reach() const;
    [[nodiscard]] SessionReach reachOfEarlier() const;
    [[nodiscard]] QHBoxLayout* whoCanJoinEarlier();
    [[nodiscard]] QString chosenFile() const;
    void chooseEarlier();
    void preselectEarlier();
    void resume();
    void refresh();
    void refreshReadiness();
    void refreshEarlier();

    StoredSessionsModel& m_stored;
    PlannedPatient& m_patient;
    Readiness m_readiness;
    QString m_folder;
    QLineEdit* m_name;
    QComboBox* m_who;
    QLineEdit* m_figures;
    QPushButton* m_browse;
    QLineEdit* m_site;
    QPushButton* m_begin;
    QListView* m_list;
    QLabel* m_none;
    QComboBox* m_earlierReach; ///< who can join the chosen one
    QLabel* m_earlierMeaning;
    QPushButton* m_resume;
    QButtonGroup* m_reach;
    QLabel* m_meaning;
    QGridLayout* m_ready;
    PatientPicture* m_picture;
    QLabel* m_missing;
    MessageLine* m_problem;
    bool m_isBusy = false;
    bool m_isPreselecting = false;
    /// Who can join the earlier session in place of who could last, where a person said so, also as
    /// the program was started.
    std::optional<SessionReach> m_reachWanted;
    QString m_reachOf; ///< file of the earlier session of which that was said
    QString m_chosen;  ///< file of the earlier session that a person chose last
};

} // namespace carina
