#include "ui/import/import_dialog.h"

#include "models/errors/error_text.h"
#include "models/patient/set_words.h"
#include "widgets/dialog_buttons.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kSurface = 0; ///< columns
constexpr int kTriangles = 1;
constexpr int kRole = 2;
constexpr int kWholeProgress = 1000;
constexpr QSize kRoomy{900, 640};
constexpr int kLeftOutData = -1;
constexpr std::size_t kFaultsNamed = 8;

QLabel* wrapped(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1String{name});
    label->setWordWrap(true);
    return label;
}

} // namespace

ImportDialog::ImportDialog(SetImport& import, QWidget* parent)
    : QDialog{parent},
      m_import{import},
      m_step{wrapped("step")},
      m_progress{new QProgressBar},
      m_review{new QWidget},
      m_words{new QLineEdit},
      m_surfaces{new QTableWidget},
      m_unit{new QComboBox},
      m_axes{new QComboBox},
      m_faults{wrapped("faults")},
      m_use{new QPushButton{tr("&Use this patient")}}
{
    setWindowTitle(
        tr("Anatomy set %1").arg(QString::fromStdString(m_import.folder().filename().string())));
    resize(kRoomy); // at once, for it stays where it comes up
    m_step->setText(tr("Reading the files …"));
    m_progress->setRange(0, kWholeProgress);
    m_progress->setAccessibleName(tr("Progress of the import"));
    layOut();
    connect(&m_import, &SetImport::progressed, this, &ImportDialog::showProgress);
    connect(&m_import, &SetImport::reviewed, this, &ImportDialog::review);
    connect(&m_import, &SetImport::finished, this, &ImportDialog::end);
    m_import.start();
}

void ImportDialog::layOut()
{
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setPlaceholderText(tr("Find surfaces by words in their names"));
    m_words->setAccessibleName(tr("Filter: words in the names of surfaces"));
    m_words->setClearButtonEnabled(true);
    m_surfaces->setObjectName(QStringLiteral("surfaces"));
    m_surfaces->setAccessibleName(tr("Surfaces and what they are recognised as"));
    m_surfaces->setColumnCount(3);
    m_surfaces->setHorizontalHeaderLabels({tr("Surface"), tr("Triangles"), tr("Recognised as")});
    m_surfaces->horizontalHeader()->setSectionResizeMode(kSurface, QHeaderView::Stretch);
    m_surfaces->verticalHeader()->hide();
    m_surfaces->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_surfaces->setTabKeyNavigation(false); // else Tab never comes out of it
    m_unit->setObjectName(QStringLiteral("unit"));
    m_unit->setAccessibleName(tr("Unit of the files"));
    m_axes->setObjectName(QStringLiteral("axes"));
    m_axes->setAccessibleName(tr("Where the axes of the files point"));
    auto* frame = new QFormLayout;
    frame->addRow(tr("U&nit"), m_unit);
    frame->addRow(tr("A&xes point"), m_axes);
    auto* reviewed = new QVBoxLayout{m_review};
    reviewed->setContentsMargins({});
    reviewed->addWidget(m_words);
    reviewed->addWidget(m_surfaces, 1);
    reviewed->addLayout(frame);
    reviewed->addWidget(m_faults);
    m_review->hide();
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    m_use->setObjectName(QStringLiteral("use"));
    m_use->setEnabled(false);
    buttons->addButton(m_use, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
    connect(m_use, &QPushButton::clicked, this, &ImportDialog::use);
    connect(m_words, &QLineEdit::textChanged, this, &ImportDialog::filter);
    auto* column = new QVBoxLayout{this};
    column->addWidget(m_step);
    column->addWidget(m_progress);
    column->addWidget(m_review, 1);
    column->addWidget(buttons);
    leadTabToCancel(*buttons, *m_use);
}

void ImportDialog::showProgress(double share)
{
    m_progress->setValue(qRound(share * kWholeProgress));
}

void ImportDialog::review(const SetDraft& draft)
{
    m_draft = draft;
    fillSurfaces(draft);
    fillFrame(draft);
    QStringList faults;
    for (std::size_t i = 0; i < std::min(kFaultsNamed, draft.faults.size()); ++i)
        faults += tr("▲ Left out: %1").arg(errorText(draft.faults[i].error));
    if (draft.faults.size() > kFaultsNamed)
        faults += tr("and %n more", nullptr, int(draft.faults.size() - kFaultsNamed));
    m_faults->setText(faults.join(QLatin1Char{'\n'}));
    m_faults->setVisible(!faults.isEmpty());
    m_step->setText(draft.frame
                        ? tr("This is what the surfaces were recognised as. Correct what is wrong.")
                        : tr("▲ In no usual unit do the surfaces have the size of a person. Choose "
                             "the unit and the axes, and correct what is wrong."));
    m_progress->hide(); // nothing goes on until the person is done
    m_review->show();
    m_use->setEnabled(true);
    m_use->setDefault(true);
    m_surfaces->setFocus();
}

QComboBox* ImportDialog::roleChoice(const DraftSurface& surface)
{
    auto* choice = new QComboBox;
    choice->setAccessibleName(tr("%1 is recognised as").arg(QString::fromStdString(surface.key)));
    for (const PartRole role : allRoles())
        choice->addItem(roleWord(role), static_cast<int>(role));
    choice->addItem(tr("– leave it out –"), kLeftOutData);
    choice->setCurrentIndex(
        choice->findData(surface.role ? static_cast<int>(*surface.role) : kLeftOutData));
    return choice;
}

/// What was not recognised comes first: that is where a person is needed.
void ImportDialog::fillSurfaces(const SetDraft& draft)
{
    std::stable_partition(m_draft.surfaces.begin(), m_draft.surfaces.end(),
                          [](const DraftSurface& s) { return s.role == PartRole::Other; });
    m_surfaces->setRowCount(int(draft.surfaces.size()));
    int row = 0;
    for (const DraftSurface& surface : m_draft.surfaces) {
        m_surfaces->setItem(row, kSurface,
                            new QTableWidgetItem{QString::fromStdString(surface.key)});
        auto* count = new QTableWidgetItem{QString::number(surface.triangles)};
        count->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_surfaces->setItem(row, kTriangles, count);
        m_surfaces->setCellWidget(row, kRole, roleChoice(surface));
        ++row;
    }
    m_surfaces->resizeColumnToContents(kRole);
    m_surfaces->resizeRowsToContents();
}

void ImportDialog::fillFrame(const SetDraft& draft)
{
    const SetFrame frame = draft.frame.value_or(SetFrame{});
    for (const UnitChoice& unit : unitChoices()) {
        m_unit->addItem(unit.word, unit.metresPerUnit);
        if (unit.metresPerUnit == frame.metresPerUnit)
            m_unit->setCurrentIndex(m_unit->count() - 1);
    }
    std::vector<AxesChoice> choices = axesChoices();
    const auto asFound = [&](const AxesChoice& c) { return c.R_AF == frame.R_AF; };
    if (std::none_of(choices.begin(), choices.end(), asFound)) // a mirror image
        choices.insert(choices.begin(), {frame.R_AF, axesWord(frame.R_AF)});
    for (const AxesChoice& axes : choices) {
        m_axes->addItem(axes.word);
        if (asFound(axes))
            m_axes->setCurrentIndex(m_axes->count() - 1);
    }
}

SetCorrections ImportDialog::corrections() const
{
    SetCorrections corrections;
    for (std::size_t i = 0; i < m_draft.surfaces.size(); ++i) {
        const DraftSurface& surface = m_draft.surfaces[i];
        const auto* choice =
            qobject_cast<QComboBox*>(m_surfaces->cellWidget(static_cast<int>(i), kRole));
        const int chosen = choice->currentData().toInt();
        const auto role =
            chosen == kLeftOutData ? std::nullopt : std::optional{static_cast<PartRole>(chosen)};
        if (role != surface.role)
            corrections.roles[surface.key] = role;
    }
    SetFrame frame = m_draft.frame.value_or(SetFrame{});
    frame.metresPerUnit = m_unit->currentData().toDouble();
    for (const AxesChoice& axes : axesChoices())
        if (axes.word == m_axes->currentText())
            frame.R_AF = axes.R_AF;
    if (!m_draft.frame || frame.metresPerUnit != m_draft.frame->metresPerUnit
        || frame.R_AF != m_draft.frame->R_AF)
        corrections.frame = frame;
    return corrections;
}

void ImportDialog::filter(const QString& words)
{
    for (int row = 0; row < m_surfaces->rowCount(); ++row)
        m_surfaces->setRowHidden(
            row, !m_surfaces->item(row, kSurface)->text().contains(words, Qt::CaseInsensitive));
}

void ImportDialog::use()
{
    m_use->setEnabled(false);
    m_review->setEnabled(false);
    m_step->setText(tr("Building the patient …"));
    m_progress->show();
    m_import.accept(corrections());
}

/// The import ends by itself soon, and then this does.
void ImportDialog::reject()
{
    m_step->setText(tr("Stopping …"));
    m_import.cancel();
}

void ImportDialog::end() { done(m_import.result() ? Accepted : Rejected); }

} // namespace carina
