#include "ui/tracker/tracker_dialog.h"

#include "models/errors/error_text.h"
#include "ui/tracker/calibration_dialog.h"
#include "ui/tracker/server_fields.h"
#include "ui/tracker/simulated_fields.h"
#include "ui/tracker/tracker_tools.h"
#include "ui/tracker/webcam_fields.h"
#include "widgets/dialog_buttons.h"
#include "widgets/plain_label.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QShowEvent>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kWidth = 620;
constexpr int kFoundHeight = 110;
constexpr int kIndent = 24;
constexpr int kWindowFrame = 48; // with its title, as window managers draw it

/// Asks for the height of all of its content, and scrolls where it has less.
class RowsArea : public QScrollArea
{
public:
    [[nodiscard]] QSize sizeHint() const override
    {
        const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
        const int width = std::max(minimumWidth() - bar, 0);
        const QWidget& rows = *widget();
        return {minimumWidth(),
                rows.hasHeightForWidth() ? rows.heightForWidth(width) : rows.sizeHint().height()};
    }
};

QLabel* wrappingLabel(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1String{name});
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

QLineEdit* namedEdit(const char* name, const QString& label)
{
    auto* edit = new QLineEdit;
    edit->setObjectName(QLatin1String{name});
    edit->setAccessibleName(label);
    return edit;
}

} // namespace

TrackerDialog::TrackerDialog(const TrackerForm& begin, const std::vector<OfferedAddress>& offered,
                             const std::vector<OfferedAddress>& webcams, QWidget* parent)
    : QDialog{parent},
      m_area{new RowsArea},
      m_rows{new QVBoxLayout},
      m_sources{new QButtonGroup{this}},
      m_simulated{new SimulatedFields},
      m_address{new QComboBox},
      m_poses{new QComboBox},
      m_rate{new QComboBox},
      m_tools{new TrackerTools},
      m_server{new ServerFields},
      m_webcam{new WebcamFields{webcams}},
      m_try{new QPushButton{tr("&Look whether it answers")}},
      m_found{wrappingLabel("found")},
      m_recording{namedEdit("recording", tr("File of the recording"))},
      m_isLooped{new QCheckBox{tr("Play it &again and again")}},
      m_description{namedEdit("description", tr("File that describes the tracker"))},
      m_calibrate{new QPushButton{tr("Cali&brate its camera…")}},
      m_conversation{namedEdit("conversation", tr("File for the bytes of the device"))},
      m_recordRow{new QWidget},
      m_missing{wrappingLabel("missing")},
      m_use{new QPushButton{tr("&Use this tracker")}}
{
    setWindowTitle(tr("Connect a tracker"));
    m_isLooped->setObjectName(QStringLiteral("looped"));
    layOut();
    addSource(TrackerSource::Simulated,
              tr("&Simulated tracker and manikin, to try the program without hardware"),
              m_simulated);
    addSource(TrackerSource::Polaris, tr("&Polaris or another tracker of NDI"),
              polarisFields(offered));
    addSource(TrackerSource::OpenIgtLink, tr("A server of Open&IGTLink, such as PLUS"), m_server);
    addSource(TrackerSource::Webcam, tr("A webcam that sees t&he printed tools"), m_webcam);
    addSource(TrackerSource::Recording, tr("A &recording, of poses or of the bytes of a device"),
              fileFields(*m_recording, tr("Recording"),
                         tr("Recordings (*.mha *.csv *.tum *.log *.txt);;Poses (*.mha *.csv "
                            "*.tum *.txt);;Bytes of a device (*.log *.txt);;All files (*)"),
                         m_isLooped));
    addSource(TrackerSource::Description, tr("A tracker that a &file describes, also one of PLUS"),
              descriptionFields());
    addRecordRow();
    m_rows->addStretch();
    fill(begin);
    connectFields();
    refresh();
    leadTabToCancel(*findChild<QDialogButtonBox*>(), *m_use); // the rows above came after it
}

void TrackerDialog::layOut()
{
    m_missing->setAccessibleName(tr("What is missing"));
    m_use->setObjectName(QStringLiteral("use"));
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    buttons->addButton(m_use, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QWidget;
    rows->setLayout(m_rows);
    m_rows->setContentsMargins({});
    m_area->setObjectName(QStringLiteral("rows"));
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setFocusPolicy(Qt::NoFocus);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setWidgetResizable(true);
    m_area->setWidget(rows);
    auto* column = new QVBoxLayout{this};
    column->addWidget(new PlainLabel{tr("Where are the poses of the tools to come from?")});
    column->addWidget(m_area, 1);
    column->addWidget(m_missing);
    column->addWidget(buttons);
    m_use->setDefault(true); // of this dialog, now that it is in it
}

void TrackerDialog::addSource(TrackerSource source, const QString& text, QWidget* details)
{
    auto* button = new QRadioButton{text};
    button->setObjectName(QStringLiteral("source%1").arg(int(source)));
    m_sources->addButton(button, int(source));
    m_rows->addWidget(button);
    m_details[std::size_t(source)] = details;
    details->setContentsMargins(kIndent, 0, 0, 0);
    m_rows->addWidget(details);
}

/// How a Polaris is asked for poses, and how fast its serial port may be.
void TrackerDialog::offerPoses()
{
    m_poses->setObjectName(QStringLiteral("poses"));
    m_poses->setAccessibleName(tr("How the tracker is asked for poses"));
    m_poses->addItem(tr("it is asked by BX: binary and short"), int(NdiPoseReply::Bx));
    m_poses->addItem(tr("it is asked by BX2: with the device's own time"), int(NdiPoseReply::Bx2));
    m_poses->addItem(tr("it is asked by TX: text"), int(NdiPoseReply::Tx));
    m_rate->setObjectName(QStringLiteral("fastestRate"));
    m_rate->setAccessibleName(tr("Fastest rate of the serial port"));
    for (const int rate : offeredRates())
        m_rate->addItem(tr("%1 bits/s").arg(rate), rate);
}

QWidget* TrackerDialog::polarisFields(const std::vector<OfferedAddress>& offered)
{
    offerPoses();
    m_address->setObjectName(QStringLiteral("address"));
    m_address->setAccessibleName(tr("Serial port, or address and port on the network"));
    m_address->setEditable(true);
    m_address->setInsertPolicy(QComboBox::NoInsert);
    m_address->lineEdit()->setPlaceholderText(QStringLiteral("192.0.2.7:8765"));
    for (const OfferedAddress& each : offered)
        m_address->addItem(each.text, each.address);
    m_try->setObjectName(QStringLiteral("try"));
    m_try->setAutoDefault(false);
    m_found->setAccessibleName(tr("What was found"));
    m_found->setMinimumHeight(kFoundHeight);
    m_found->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* ports = wrappingLabel("ports");
    ports->setText(offered.empty()
                       ? tr("No serial port was found on this computer.")
                       : tr("Serial ports found on this computer: %1").arg(offered.size()));
    auto* fields = new QWidget;
    auto* form = new QFormLayout{fields};
    form->addRow(tr("&Address"), m_address);
    form->addRow(QString{}, ports);
    form->addRow(tr("Pos&es"), m_poses);
    form->addRow(tr("Fas&test rate"), m_rate);
    form->addRow(tr("Tools"), m_tools);
    form->addRow(m_try, m_found);
    return fields;
}

QWidget* TrackerDialog::fileFields(QLineEdit& file, const QString& title, const QString& kinds,
                                   QCheckBox* choice)
{
    auto* browse = new QPushButton{tr("Browse…")};
    browse->setAccessibleName(tr("Browse: %1").arg(title));
    browse->setAutoDefault(false);
    connect(browse, &QPushButton::clicked, this, [this, &file, title, kinds] {
        const QString chosen = QFileDialog::getOpenFileName(this, title, file.text(), kinds);
        if (!chosen.isEmpty())
            file.setText(chosen);
    });
    auto* fields = new QWidget;
    auto* row = new QHBoxLayout{fields};
    auto* caption = new PlainLabel{tr("File")};
    caption->setBuddy(&file);
    row->addWidget(caption);
    row->addWidget(&file, 1);
    row->addWidget(browse);
    if (choice != nullptr)
        row->addWidget(choice);
    return fields;
}

QWidget* TrackerDialog::descriptionFields()
{
    m_calibrate->setObjectName(QStringLiteral("calibrate"));
    m_calibrate->setAutoDefault(false);
    QWidget* fields = fileFields(*m_description, tr("Description of a tracker"),
                                 tr("Descriptions (*.json *.xml)"));
    fields->layout()->addWidget(m_calibrate);
    return fields;
}

/// Below the sources, as several have it.
void TrackerDialog::addRecordRow()
{
    auto* browse = new QPushButton{tr("Browse…")};
    browse->setAccessibleName(tr("Browse: file for the bytes of the device"));
    browse->setAutoDefault(false);
    connect(browse, &QPushButton::clicked, this, &TrackerDialog::chooseConversation);
    auto* label = new PlainLabel{tr("Record its b&ytes into")};
    label->setBuddy(m_conversation);
    m_conversation->setPlaceholderText(tr("nothing"));
    m_recordRow->setContentsMargins(kIndent, 0, 0, 0);
    auto* row = new QHBoxLayout{m_recordRow};
    row->addWidget(label);
    row->addWidget(m_conversation, 1);
    row->addWidget(browse);
    m_rows->addWidget(m_recordRow);
}

void TrackerDialog::chooseConversation()
{
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Record the bytes to and from the device"),
        m_conversation->text().isEmpty() ? QStringLiteral("device.log") : m_conversation->text(),
        tr("Bytes of a device (*.log)"), nullptr, QFileDialog::DontConfirmOverwrite);
    if (!file.isEmpty())
        m_conversation->setText(file);
}

void TrackerDialog::offerToRecord()
{
    m_offersToRecord = true;
    refresh();
}

void TrackerDialog::fill(const TrackerForm& form)
{
    m_simulated->fill(form);
    m_webcam->fill(form);
    m_conversation->setText(form.conversation);
    m_sources->button(int(form.source))->setChecked(true);
    if (!form.address.isEmpty())
        m_address->setEditText(form.address);
    m_poses->setCurrentIndex(m_poses->findData(int(form.poses)));
    if (m_rate->findData(form.fastestRate) < 0) // one that was written by hand
        m_rate->addItem(tr("%1 bits/s").arg(form.fastestRate), form.fastestRate);
    m_rate->setCurrentIndex(m_rate->findData(form.fastestRate));
    m_tools->setTools(form.tools);
    m_server->fill(form);
    m_recording->setText(form.recording);
    m_isLooped->setChecked(form.isLooped);
    m_description->setText(form.description);
}

void TrackerDialog::connectFields()
{
    connect(m_sources, &QButtonGroup::idToggled, this, [this] {
        edited();
        if (isVisible())
            fit();
    });
    connect(m_address, &QComboBox::editTextChanged, this, &TrackerDialog::edited);
    for (const QComboBox* choice : {m_poses, m_rate})
        connect(choice, &QComboBox::currentIndexChanged, this, &TrackerDialog::edited);
    connect(m_tools, &TrackerTools::changed, this, &TrackerDialog::edited);
    connect(m_server, &ServerFields::changed, this, &TrackerDialog::edited);
    connect(m_simulated, &SimulatedFields::changed, this, &TrackerDialog::edited);
    connect(m_webcam, &WebcamFields::changed, this, &TrackerDialog::edited);
    connect(m_webcam, &WebcamFields::calibrationWanted, this, &TrackerDialog::calibrate);
    connect(m_conversation, &QLineEdit::textChanged, this, &TrackerDialog::edited);
    connect(m_recording, &QLineEdit::textChanged, this, &TrackerDialog::edited);
    connect(m_description, &QLineEdit::textChanged, this, &TrackerDialog::edited);
    connect(m_try, &QPushButton::clicked, this, &TrackerDialog::tryIt);
    connect(m_calibrate, &QPushButton::clicked, this, &TrackerDialog::calibrate);
    connect(&m_trial, &TrackerTrial::changed, this, &TrackerDialog::refresh);
    connect(&m_reading, &BackgroundWork::progressed, this, &TrackerDialog::refresh);
    connect(&m_reading, &BackgroundWork::finished, this, &TrackerDialog::takeRead);
}

TrackerForm TrackerDialog::form() const
{
    const int offered = m_address->findText(m_address->currentText());
    TrackerForm form{.source = TrackerSource(m_sources->checkedId()),
                     .address = offered < 0 ? m_address->currentText()
                                            : m_address->itemData(offered).toString(),
                     .tools = m_tools->tools(),
                     .poses = NdiPoseReply(m_poses->currentData().toInt()),
                     .fastestRate = m_rate->currentData().toInt(),
                     .recording = m_recording->text(),
                     .isLooped = m_isLooped->isChecked(),
                     .description = m_description->text(),
                     .conversation = m_conversation->text()};
    m_server->read(form);
    m_simulated->read(form);
    m_webcam->read(form);
    return form;
}

/// What was found is not of these fields any more.
void TrackerDialog::edited()
{
    m_trial.end();
    want(false);
    m_reading.cancel();
    refresh();
}

void TrackerDialog::want(bool wants)
{
    if (std::exchange(m_wants, wants) != wants)
        Q_EMIT devicesWanted(wants);
}

void TrackerDialog::tryIt()
{
    want(true);
    const auto chosen = choiceOf(form());
    const auto begun = chosen.and_then([this](const TrackerChoice& choice) {
        return m_trial.begin(std::get<TrackerDescription>(choice.device));
    });
    if (!begun)
        m_missing->setText(errorText(begun.error()));
    m_area->ensureWidgetVisible(m_found);
}

void TrackerDialog::calibrate()
{
    const auto chosen = choiceOf(form());
    if (!chosen)
        return m_missing->setText(errorText(chosen.error()));
    auto camera = cameraOf(*chosen);
    if (!camera)
        return m_missing->setText(tr("This file describes a tracker that is no camera."));
    const bool isDescribed = form().source == TrackerSource::Description;
    if (!isDescribed && camera->file.isEmpty())
        camera->file = QFileDialog::getSaveFileName(
            this, tr("Where is the calibration to be written?"), QStringLiteral("camera.json"),
            tr("Calibrations (*.json)"));
    if (camera->file.isEmpty())
        return;
    want(true);
    const bool isCalibrated = CalibrationDialog{*camera, this}.exec() == QDialog::Accepted;
    want(false);
    if (!isCalibrated)
        return;
    if (!isDescribed)
        return m_webcam->setCalibration(camera->file);
    const auto named =
        nameCalibration(form().description.trimmed().toStdString(), camera->file.toStdString());
    if (!named)
        m_missing->setText(errorText(named.error()));
}

void TrackerDialog::accept()
{
    m_simulated->enterTyped();
    if (whatIsMissing(form()) || m_reading.isUnderWay())
        return;
    m_trial.end();
    m_server->endTrial();
    m_asked = form();
    m_reading.start(
        [this, chosen = m_asked](const Progress& goesOn) { m_read = choiceOf(chosen, goesOn); });
    refresh();
}

void TrackerDialog::done(int result)
{
    m_trial.end();
    want(false);
    QDialog::done(result);
}

void TrackerDialog::takeRead()
{
    refresh();
    auto read = std::exchange(m_read, std::nullopt);
    if (form() != m_asked)
        return; // a field was changed meanwhile
    if (!*read)
        return m_missing->setText(errorText(read->error()));
    m_choice = **std::move(read);
    QDialog::accept();
}

void TrackerDialog::refresh()
{
    const auto missing = whatIsMissing(form());
    const bool isReading = m_reading.isUnderWay();
    m_missing->setText(isReading ? tr("Reading: %1 %").arg(m_reading.percent())
                                 : missing.value_or(QString{}));
    m_use->setEnabled(!missing && !isReading);
    m_try->setEnabled(!missing);
    m_calibrate->setEnabled(canCalibrateCamera(form()));
    m_webcam->setCanCalibrate(!missing);
    m_recordRow->setVisible(m_offersToRecord && canHaveConversation(form().source));
    m_found->setText(m_trial.text());
    for (std::size_t source = 0; source < m_details.size(); ++source)
        m_details[source]->setVisible(int(source) == m_sources->checkedId());
}

void TrackerDialog::showEvent(QShowEvent* event)
{
    fit();
    QDialog::showEvent(event);
}

/// As wide as the widest source needs, as high as the chosen one, and within the screen.
void TrackerDialog::fit()
{
    int width = std::max(kWidth, m_rows->minimumSize().width());
    for (const QWidget* details : m_details)
        width = std::max(width, details->minimumSizeHint().width());
    m_area->setMinimumWidth(width + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    m_area->updateGeometry();
    const QRect screenArea = screen()->availableGeometry().adjusted(0, kWindowFrame, 0, 0);
    resize(sizeHint().boundedTo(screenArea.size()));
    if (isVisible() && geometry().bottom() > screenArea.bottom())
        move(x(), y() - (geometry().bottom() - screenArea.bottom()));
}

} // namespace carina
