#include "ui/registration/landmarks_page.h"

#include "ui/registration/error_table.h"
#include "ui/registration/landmark_list.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr double kWeak_mm = 2.0; ///< RMS at a target, from touches of 1 mm, that is worth a word

QString landmarkFiles() { return LandmarksPage::tr("Landmarks (*.csv *.fcsv *.mrk.json)"); }

} // namespace

LandmarksPage::LandmarksPage(RegistrationModel& registration)
    : RegistrationPage{registration},
      m_sets{new QComboBox{this}},
      m_list{new LandmarkList{registration, this}},
      m_snapping{new QCheckBox{tr("&Snap to tips and ridges"), this}},
      m_forecast{new ErrorTable{this}},
      m_advice{new PlainLabel{this}}
{
    m_sets->setObjectName(QStringLiteral("sets"));
    m_sets->setAccessibleName(tr("Set of landmarks"));
    for (const LandmarkCatalogue& set : registration.landmarkTask().offered())
        m_sets->addItem(
            tr("%1, %2 landmarks").arg(QString::fromStdString(set.name)).arg(set.landmarks.size()));
    m_list->setObjectName(QStringLiteral("landmarks"));
    m_list->showColumns({LandmarkTableModel::Name, LandmarkTableModel::Touched});
    m_snapping->setObjectName(QStringLiteral("snapping"));
    m_snapping->setToolTip(
        tr("A click takes the nearest tip or ridge of the bone, which a finger can feel"));
    m_advice->setObjectName(QStringLiteral("advice"));
    m_advice->setWordWrap(true);
    m_advice->setToolTip(tr("Fiducial localisation error (FLE): distance between the point touched "
                            "and the true landmark"));
    layOut();
    connectTask();
}

void LandmarksPage::layOut()
{
    auto* load = new QPushButton{tr("I&mport…"), this};
    load->setToolTip(tr("Landmarks from CSV or 3D Slicer"));
    connect(load, &QPushButton::clicked, this, &LandmarksPage::chooseImport);
    auto* save = new QPushButton{tr("&Export…"), this};
    connect(save, &QPushButton::clicked, this, &LandmarksPage::chooseExport);
    auto* files = new QHBoxLayout;
    files->addWidget(m_snapping, 1);
    files->addWidget(load);
    files->addWidget(save);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->addWidget(m_sets);
    column->addWidget(m_list);
    column->addLayout(files);
    column->addWidget(m_forecast);
    column->addWidget(m_advice);
    column->addStretch();
}

void LandmarksPage::connectTask()
{
    connect(m_sets, &QComboBox::activated, this, [this](int set) {
        if (std::size_t(set) < registration().landmarkTask().offered().size())
            registration().landmarkTask().chooseSet(std::size_t(set));
    });
    connect(m_list, &LandmarkList::chosen, this,
            [this](std::size_t landmark) { registration().landmarkTask().choose(landmark); });
    connect(m_snapping, &QCheckBox::toggled, this,
            [this](bool snaps) { registration().landmarkTask().setSnapping(snaps); });
}

void LandmarksPage::refresh()
{
    const LandmarkTask& task = registration().landmarkTask();
    const int offered = int(task.offered().size());
    while (m_sets->count() > offered)
        m_sets->removeItem(offered);
    if (!task.chosenSet())
        m_sets->addItem(tr("%1, changed").arg(QString::fromStdString(task.catalogue().name)));
    m_sets->setCurrentIndex(task.chosenSet() ? int(*task.chosenSet()) : offered);
    m_snapping->setChecked(task.isSnapping());
    m_list->refresh();
    m_forecast->show(task.forecast());
    m_advice->setText(advice());
}

QString LandmarksPage::advice() const
{
    const LandmarkTask& task = registration().landmarkTask();
    const std::vector<ExpectedError> forecast = task.forecast();
    if (forecast.empty())
        return tr("▲ These landmarks are at one place or on one line: no fit is possible.");
    QStringList sentences;
    QStringList weak;
    for (const ExpectedError& error : forecast)
        if (error.rms_mm > kWeak_mm)
            weak << error.name;
    if (!weak.isEmpty())
        sentences << tr("▲ These landmarks lie nearly on one line, or far from these targets: %1.")
                         .arg(weak.join(tr(", ")));
    if (const auto help = task.wouldHelp())
        sentences << tr("The landmark that would help most: %1, then %2 mm at the worst target.")
                         .arg(help->first)
                         .arg(help->second, 0, 'f', 1);
    sentences << tr("Expected for a fiducial localisation error (FLE) of 1 mm (RMS).");
    return sentences.join(QLatin1Char(' '));
}

void LandmarksPage::chooseImport()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Import landmarks"), {}, landmarkFiles());
    if (!file.isEmpty())
        registration().landmarkTask().importFrom(file.toStdString());
}

void LandmarksPage::chooseExport()
{
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export landmarks"), QStringLiteral("landmarks.mrk.json"), landmarkFiles());
    if (!file.isEmpty())
        registration().landmarkTask().exportTo(file.toStdString());
}

} // namespace carina
