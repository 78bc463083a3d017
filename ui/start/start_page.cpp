#include "ui/start/start_page.h"

#include "ui/message_line.h"
#include "ui/start/patient_picture.h"
#include "widgets/plain_label.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QRadioButton>
#include <QScopedValueRollback>
#include <QTimer>

namespace carina
{
namespace
{

constexpr int kColumnWidth = 560;
constexpr int kReadinessInterval_ms = 3000;
constexpr int kReadyNameColumn = 0;
constexpr int kReadyStateColumn = 1;

/// What is behind the entries that are no patient themselves.
const QString kFigures = QStringLiteral("figures");
const QString kFolder = QStringLiteral("folder");

QLabel* lineOfWords(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1String{name});
    label->setWordWrap(true);
    return label;
}

QPushButton* wordedButton(const char* name, const QString& words)
{
    auto* button = new QPushButton{words};
    button->setObjectName(QLatin1String{name});
    return button;
}

} // namespace

StartPage::StartPage(StoredSessionsModel& stored, PlannedPatient& patient, const SessionPlan& begin,
                     Readiness readiness)
    : m_stored{stored},
      m_patient{patient},
      m_readiness{std::move(readiness)},
      m_folder{begin.folder},
      m_name{new QLineEdit{begin.name}},
      m_who{new QComboBox},
      m_figures{new QLineEdit},
      m_browse{wordedButton("browse", tr("Choose a &folder…"))},
      m_site{new QLineEdit{begin.site}},
      m_begin{wordedButton("begin", tr("&Begin the session"))},
      m_list{new QListView},
      m_none{lineOfWords("none")},
      m_earlierReach{new QComboBox},
      m_earlierMeaning{lineOfWords("earlierMeaning")},
      m_resume{wordedButton("resume", tr("&Resume"))},
      m_reach{new QButtonGroup{this}},
      m_meaning{lineOfWords("meaning")},
      m_ready{new QGridLayout},
      m_picture{new PatientPicture},
      m_missing{lineOfWords("missing")},
      m_problem{new MessageLine}
{
    setWindowTitle(tr("Carina instructor"));
    if (begin.reach != SessionReach::ThisComputer)
        m_reachWanted = begin.reach;
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setWordWrap(true);
    auto* left = new QVBoxLayout;
    for (QGroupBox* box : {whoCanJoin(begin.reach), newSession(begin), earlierSessions()})
        left->addWidget(box);
    left->setStretch(2, 1);
    left->addWidget(m_problem);
    auto* right = new QVBoxLayout;
    right->addWidget(m_picture, 1);
    right->addWidget(whatIsReady());
    auto* columns = new QHBoxLayout{this};
    columns->addLayout(left);
    columns->addLayout(right, 1);
    connect(&m_patient, &PlannedPatient::changed, this, &StartPage::refresh);
    connect(&m_stored, &QAbstractItemModel::rowsInserted, this, &StartPage::refreshEarlier);
    connect(&m_stored, &QAbstractItemModel::modelReset, this, &StartPage::refreshEarlier);
    connect(&m_stored, &StoredSessionsModel::completed, this, &StartPage::refreshEarlier);
    auto* look = new QTimer{this};
    connect(look, &QTimer::timeout, this, &StartPage::refreshReadiness);
    look->start(kReadinessInterval_ms);
    choosePatient();
    refreshEarlier();
    m_name->setFocus();
    m_name->selectAll();
}

bool StartPage::event(QEvent* event)
{
    if (event->type() == QEvent::WindowActivate)
        refreshReadiness();
    return QWidget::event(event);
}

QGroupBox* StartPage::newSession(const SessionPlan& begin)
{
    auto* box = new QGroupBox{tr("A new session")};
    box->setFixedWidth(kColumnWidth);
    m_name->setObjectName(QStringLiteral("name"));
    m_name->setAccessibleName(tr("Name of the session"));
    connect(m_name, &QLineEdit::textChanged, this, &StartPage::refresh);
    connect(m_name, &QLineEdit::returnPressed, m_begin, &QPushButton::click);
    m_begin->setDefault(true);
    connect(m_begin, &QPushButton::clicked, this, [this] { Q_EMIT beginWanted(plan()); });
    auto* form = new QFormLayout{box};
    form->addRow(tr("&Name"), m_name);
    addPatient(*form, begin);
    addSite(*form, begin.site);
    form->addRow(m_missing);
    form->addRow(m_begin);
    return box;
}

void StartPage::addPatient(QFormLayout& form, const SessionPlan& begin)
{
    m_who->setObjectName(QStringLiteral("patient"));
    m_who->setAccessibleName(tr("Patient"));
    m_who->addItem(tr("Boy of 12 years, 150 cm"), QStringLiteral("child"));
    m_who->addItem(tr("Girl of 12 years, 150 cm"), QStringLiteral("child, girl"));
    m_who->addItem(tr("Man of 30 years, 175 cm"), QStringLiteral("adult"));
    m_who->addItem(tr("Woman of 30 years, 175 cm"), QStringLiteral("adult, woman"));
    m_who->addItem(tr("Infant: boy of 1 year, 75 cm"), QStringLiteral("1 year, 75 cm, boy"));
    m_who->addItem(tr("From figures"), kFigures);
    m_who->addItem(tr("From a folder of surfaces"), kFolder);
    const int known =
        begin.patient.isEmpty() ? 0 : m_who->findData(begin.patient); // as without --patient
    m_who->setCurrentIndex(!begin.folder.isEmpty() ? m_who->findData(kFolder)
                           : known >= 0            ? known
                                                   : m_who->findData(kFigures));
    m_figures->setObjectName(QStringLiteral("figures"));
    m_figures->setAccessibleName(tr("Figures of the patient"));
    // Words that patientFromWords reads, in English whatever the language.
    m_figures->setText(known >= 0 ? QStringLiteral("45 years, 182 cm, man") : begin.patient);
    m_figures->setToolTip(
        tr("Age in years, or of a small child as “newborn” or “3 months”, height in cm, man, "
           "woman, boy or girl, slim or obese, and as in “airway 250 mm” the way from teeth to "
           "carina"));
    m_browse->setToolTip(tr("An anatomy set: surfaces in OBJ, PLY, STL or glTF"));
    connect(m_who, &QComboBox::currentIndexChanged, this, &StartPage::choosePatient);
    connect(m_figures, &QLineEdit::textChanged, this, &StartPage::choosePatient);
    connect(m_browse, &QPushButton::clicked, this, &StartPage::chooseFolder);
    form.addRow(tr("&Patient"), m_who);
    form.addRow(tr("Fi&gures"), m_figures);
    form.addRow(tr("Folder"), m_browse);
}

void StartPage::addSite(QFormLayout& form, const QString& site)
{
    m_site->setObjectName(QStringLiteral("site"));
    m_site->setAccessibleName(tr("Site: file of the registration wizard"));
    m_site->setPlaceholderText(tr("empty: no manikin of this computer takes part"));
    m_site->setText(site);
    auto* choose = wordedButton("chooseSite", tr("Cho&ose…"));
    choose->setAccessibleName(tr("Choose the file of the site"));
    connect(choose, &QPushButton::clicked, this, &StartPage::chooseSite);
    connect(m_site, &QLineEdit::textChanged, this, &StartPage::refreshReadiness);
    auto* row = new QHBoxLayout;
    row->addWidget(m_site, 1);
    row->addWidget(choose);
    auto* label = new PlainLabel{tr("&Site")};
    label->setBuddy(m_site);
    form.addRow(label, row);
}

QGroupBox* StartPage::whoCanJoin(SessionReach reach)
{
    auto* box = new QGroupBox{tr("Who can join a new session")};
    box->setFixedWidth(kColumnWidth);
    auto* row = new QHBoxLayout;
    const auto add = [&](SessionReach which, const char* name, const QString& words) {
        auto* button = new QRadioButton{words};
        button->setObjectName(QLatin1String{name});
        button->setChecked(which == reach);
        m_reach->addButton(button, int(which));
        row->addWidget(button);
    };
    add(SessionReach::ThisComputer, "thisComputer", tr("&This computer"));
    add(SessionReach::Network, "network", tr("Th&is network"));
    add(SessionReach::ByLink, "byLink", tr("By &link"));
    connect(m_reach, &QButtonGroup::idToggled, this, &StartPage::refresh);
    m_meaning->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing moves beneath it
    auto* column = new QVBoxLayout{box};
    column->addLayout(row);
    column->addWidget(m_meaning);
    return box;
}

QGroupBox* StartPage::earlierSessions()
{
    auto* box = new QGroupBox{tr("An earlier session that has not ended")};
    box->setFixedWidth(kColumnWidth);
    m_list->setObjectName(QStringLiteral("earlier"));
    m_list->setAccessibleName(tr("Earlier sessions"));
    m_list->setModel(&m_stored);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setWordWrap(true); // a session has as many lines as it needs
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &StartPage::chooseEarlier);
    connect(m_list, &QListView::clicked, this, &StartPage::chooseEarlier);
    connect(m_list, &QListView::activated, this, &StartPage::resume);
    connect(m_resume, &QPushButton::clicked, this, &StartPage::resume);
    auto* column = new QVBoxLayout{box};
    column->addWidget(m_list, 1);
    column->addWidget(m_none, 0, Qt::AlignTop);
    column->addLayout(whoCanJoinEarlier());
    column->addWidget(m_earlierMeaning);
    column->addWidget(m_resume);
    return box;
}

QHBoxLayout* StartPage::whoCanJoinEarlier()
{
    m_earlierReach->setObjectName(QStringLiteral("earlierReach"));
    m_earlierReach->setAccessibleName(tr("Who can join the earlier session"));
    m_earlierReach->setToolTip(tr("At first those who could join it when it was run last"));
    m_earlierReach->addItem(tr("This computer"), int(SessionReach::ThisComputer));
    m_earlierReach->addItem(tr("This network"), int(SessionReach::Network));
    m_earlierReach->addItem(tr("By link"), int(SessionReach::ByLink));
    connect(m_earlierReach, &QComboBox::currentIndexChanged, this, &StartPage::refresh);
    connect(m_earlierReach, &QComboBox::activated, this, [this] {
        m_reachWanted = reachOfEarlier();
        m_chosen = chosenFile();
        m_reachOf = m_chosen;
    });
    auto* label = new PlainLabel{tr("Who can &join it")};
    label->setBuddy(m_earlierReach);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_earlierReach, 1);
    return row;
}

QGroupBox* StartPage::whatIsReady()
{
    auto* box = new QGroupBox{tr("What is ready")};
    m_ready->setColumnStretch(kReadyStateColumn, 1);
    box->setLayout(m_ready);
    return box;
}

SessionPlan StartPage::plan() const
{
    return {.name = m_name->text().trimmed(),
            .patient = patientWords(),
            .folder = m_who->currentData().toString() == kFolder ? m_folder : QString{},
            .site = m_site->text().trimmed(),
            .reach = reach()};
}

void StartPage::warn(const QString& problem) { m_problem->warn(problem); }

void StartPage::setBusy(bool busy)
{
    m_isBusy = busy;
    refresh();
}

/// With surfaces: how an adult breathes.
QString StartPage::patientWords() const
{
    const QString chosen = m_who->currentData().toString();
    if (chosen == kFigures)
        return m_figures->text().trimmed();
    return chosen == kFolder ? QStringLiteral("adult") : chosen;
}

SessionReach StartPage::reach() const { return static_cast<SessionReach>(m_reach->checkedId()); }

SessionReach StartPage::reachOfEarlier() const
{
    return static_cast<SessionReach>(m_earlierReach->currentData().toInt());
}

void StartPage::choosePatient()
{
    const QString chosen = m_who->currentData().toString();
    m_figures->setEnabled(chosen == kFigures);
    m_browse->setEnabled(chosen == kFolder);
    if (chosen != kFolder) {
        m_patient.want(patientWords());
    } else {
        m_patient.drop(); // who was chosen before is not laid in place of the surfaces
        if (!m_folder.isEmpty())
            Q_EMIT importWanted(m_folder);
    }
    refresh();
}

void StartPage::chooseFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("The folder with the patient's surfaces"), m_folder);
    if (folder.isEmpty())
        return;
    m_folder = folder;
    m_patient.drop();
    Q_EMIT importWanted(folder);
}

void StartPage::chooseSite()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("The site of carina-registration"), m_site->text(),
                                     tr("Sites (*site*.json);;Other names (*.json)"));
    if (!file.isEmpty())
        m_site->setText(file);
}

QString StartPage::chosenFile() const
{
    const QModelIndex current = m_list->currentIndex();
    const bool canBeChosen = current.isValid() && (m_stored.flags(current) & Qt::ItemIsEnabled);
    return canBeChosen ? m_stored.at(current.row()).file : QString{};
}

/// Who could join it is not left outside unawares, until a person says otherwise.
void StartPage::chooseEarlier()
{
    if (!chosenFile().isEmpty()) {
        const StoredSession& session = m_stored.at(m_list->currentIndex().row());
        if (m_isPreselecting && m_reachOf.isEmpty())
            m_reachOf = session.file; // as the program was started
        if (!m_isPreselecting) {
            if (session.file != m_reachOf)
                m_reachWanted.reset(); // was said of another one
            m_chosen = session.file;
        }
        m_earlierReach->setCurrentIndex(
            m_earlierReach->findData(int(m_reachWanted.value_or(session.reach))));
    }
    refresh();
}

/// What a person chose, else the last to be resumed.
void StartPage::preselectEarlier()
{
    const QScopedValueRollback preselecting{m_isPreselecting, true};
    for (int row = 0; row < m_stored.rowCount() && !m_list->currentIndex().isValid(); ++row)
        if (const QModelIndex index = m_stored.index(row);
            (m_stored.flags(index) & Qt::ItemIsEnabled)
            && (m_chosen.isEmpty() || m_stored.at(row).file == m_chosen))
            m_list->setCurrentIndex(index);
}

void StartPage::resume()
{
    if (const QString file = chosenFile(); !file.isEmpty() && !m_isBusy)
        Q_EMIT resumeWanted(file, reachOfEarlier());
}

void StartPage::refresh()
{
    const bool needsFolder = m_who->currentData().toString() == kFolder && m_folder.isEmpty();
    QString missing = faultOf(plan());
    if (missing.isEmpty() && needsFolder)
        missing = tr("Choose the folder with the patient's surfaces.");
    else if (missing.isEmpty() && !m_patient.patient() && !m_patient.isBeingMade()
             && m_patient.fault().isEmpty())
        missing = tr("Choose the folder again: its surfaces were not imported.");
    if (missing.isEmpty())
        missing = m_patient.fault();
    m_missing->setText(missing);
    const auto& patient = m_patient.patient();
    if (patient)
        m_picture->show(patient->model);
    else
        m_picture->say(m_patient.isBeingMade() ? tr("The patient is being made …")
                                               : tr("No patient is chosen yet"));
    m_begin->setEnabled(!m_isBusy && missing.isEmpty() && patient.has_value());
    m_resume->setEnabled(!m_isBusy && !chosenFile().isEmpty());
    m_meaning->setText(reachMeaning(reach()));
    m_earlierReach->setEnabled(!m_isBusy && !chosenFile().isEmpty());
    m_earlierMeaning->setVisible(!chosenFile().isEmpty());
    m_earlierMeaning->setText(reachMeaning(reachOfEarlier()));
    refreshReadiness();
}

void StartPage::refreshReadiness()
{
    const auto& patient = m_patient.patient();
    const auto lines = m_readiness(plan().site, patient ? patient->model.get() : nullptr);
    for (int row = 0; row < int(lines.size()); ++row) {
        const ReadyLine& line = lines[std::size_t(row)];
        const auto put = [&](int column, const QString& words) {
            QLayoutItem* there = m_ready->itemAtPosition(row, column);
            auto* label = there ? static_cast<QLabel*>(there->widget()) : lineOfWords("ready");
            label->setText(words);
            if (!there)
                m_ready->addWidget(label, row, column, Qt::AlignTop);
            label->show();
        };
        put(kReadyNameColumn, line.name);
        put(kReadyStateColumn, line.state);
    }
    for (int row = int(lines.size()); row < m_ready->rowCount(); ++row)
        for (const int column : {kReadyNameColumn, kReadyStateColumn})
            if (QLayoutItem* there = m_ready->itemAtPosition(row, column))
                there->widget()->hide();
}

void StartPage::refreshEarlier()
{
    const bool isEmpty = m_stored.rowCount() == 0;
    m_none->setVisible(isEmpty || !m_stored.isComplete());
    m_none->setText(!m_stored.isComplete() ? tr("Looking …") : tr("There is none."));
    m_list->setVisible(!isEmpty);
    preselectEarlier();
    refresh();
}

} // namespace carina
