#include "ui/tracker/tool_layout_dialog.h"

#include "models/errors/error_text.h"
#include "ui/message_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/marker_layout.h"
#include "widgets/plain_label.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr double kFarthestMarker_mm = 2000.0; // of NdiToolDefinition

std::vector<MarkerLayout::Point> pointsOf(const std::vector<Vec3>& markers_mm)
{
    std::vector<MarkerLayout::Point> points;
    for (const Vec3& p_mm : markers_mm)
        points.push_back({p_mm.x(), p_mm.y(), p_mm.z()});
    return points;
}

} // namespace

ToolLayoutDialog::ToolLayoutDialog(QWidget* parent)
    : QDialog{parent},
      m_title{new PlainLabel{this}},
      m_picture{new MarkerLayout{this}},
      m_number{new CheckedSpinBox{this}},
      m_places{new CheckedDoubleSpinBox{this}, new CheckedDoubleSpinBox{this},
               new CheckedDoubleSpinBox{this}},
      m_open{new QPushButton{tr("&Open a definition…"), this}},
      m_undo{new QPushButton{tr("&Undo"), this}},
      m_redo{new QPushButton{tr("&Redo"), this}},
      m_save{new QPushButton{tr("&Save as a new one…"), this}},
      m_message{new MessageLine{this}}
{
    setWindowTitle(tr("Markers of a tool"));
    m_title->setObjectName(QStringLiteral("layoutTitle"));
    m_title->setWordWrap(true);
    m_picture->setObjectName(QStringLiteral("layoutPicture"));
    m_number->setObjectName(QStringLiteral("layoutMarker"));
    m_number->setAccessibleName(tr("Number of the marker"));
    m_open->setObjectName(QStringLiteral("layoutOpen"));
    m_undo->setObjectName(QStringLiteral("layoutUndo"));
    m_redo->setObjectName(QStringLiteral("layoutRedo"));
    m_save->setObjectName(QStringLiteral("layoutSave"));
    m_message->setObjectName(QStringLiteral("layoutMessage"));
    m_message->setWordWrap(true);
    const std::array names{QStringLiteral("layoutX"), QStringLiteral("layoutY"),
                           QStringLiteral("layoutZ")};
    const std::array spoken{tr("x of the marker, in millimetres"),
                            tr("y of the marker, in millimetres"),
                            tr("z of the marker, in millimetres")};
    for (std::size_t axis = 0; axis < m_places.size(); ++axis) {
        CheckedDoubleSpinBox& box = *m_places[axis];
        box.setObjectName(names[axis]);
        box.setAccessibleName(spoken[axis]);
        box.setRange(-kFarthestMarker_mm, kFarthestMarker_mm);
        box.setDecimals(3);
        box.setSingleStep(0.1);
        box.setSuffix(tr(" mm"));
    }
    connectControls();
    layOut();
    refresh();
}

void ToolLayoutDialog::connectControls()
{
    connect(&m_layout, &ToolLayout::changed, this, &ToolLayoutDialog::refresh);
    connect(m_picture, &MarkerLayout::chosen, this, [this](int chosen) { showMarker(chosen); });
    connect(m_number, &QSpinBox::valueChanged, this,
            [this](int number) { showMarker(number - 1); });
    connect(m_number, &CheckedSpinBox::refused, m_message, &MessageLine::warn);
    for (CheckedDoubleSpinBox* box : m_places) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &ToolLayoutDialog::moveMarker);
        connect(box, &CheckedDoubleSpinBox::refused, m_message, &MessageLine::warn);
    }
    connect(m_undo, &QPushButton::clicked, &m_layout, &ToolLayout::undo);
    connect(m_redo, &QPushButton::clicked, &m_layout, &ToolLayout::redo);
    m_undo->setShortcut(QKeySequence{QKeySequence::Undo});
    m_redo->setShortcut(QKeySequence{QKeySequence::Redo});
    connect(m_open, &QPushButton::clicked, this, [this] {
        openFile(QFileDialog::getOpenFileName(this, tr("Tool definition of NDI"), {},
                                              tr("Tool definitions (*.rom)")));
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        saveTo(QFileDialog::getSaveFileName(this, tr("New tool definition"), {},
                                            tr("Tool definitions (*.rom)"), nullptr,
                                            QFileDialog::DontConfirmOverwrite));
    });
}

void ToolLayoutDialog::layOut()
{
    auto* form = new QFormLayout;
    const auto row = [&](const QString& text, QWidget* field) {
        auto* label = new PlainLabel{text, this};
        label->setBuddy(field);
        form->addRow(label, field);
    };
    row(tr("&Marker"), m_number);
    row(tr("&x"), m_places[0]);
    row(tr("&y"), m_places[1]);
    row(tr("&z"), m_places[2]);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_open, m_undo, m_redo, m_save}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    auto* column = new QVBoxLayout{this};
    column->addWidget(m_title);
    column->addWidget(m_picture, 1);
    column->addLayout(form);
    column->addLayout(buttons);
    column->addWidget(m_message);
}

int ToolLayoutDialog::marker() const { return m_number->value() - 1; }

void ToolLayoutDialog::refresh()
{
    const auto markers_mm = m_layout.markers_mm();
    m_title->setText(m_layout.isOpen()
                         ? m_layout.title()
                               + (m_layout.isChanged() ? tr(" (not saved)") : QString{})
                         : tr("Open a tool definition of NDI (.rom) to see its markers."));
    {
        const QSignalBlocker block{m_number};
        m_number->setRange(1, std::max(1, int(markers_mm.size())));
    }
    m_picture->setPoints(pointsOf(markers_mm));
    m_number->setEnabled(m_layout.isOpen());
    for (CheckedDoubleSpinBox* box : m_places)
        box->setEnabled(m_layout.isOpen());
    m_open->setEnabled(!m_layout.isChanged());
    m_open->setToolTip(m_layout.isChanged() ? tr("Save what was moved, or undo it, before")
                                            : tr("A tool definition of NDI (.rom)"));
    m_undo->setEnabled(m_layout.canUndo());
    m_redo->setEnabled(m_layout.canRedo());
    m_save->setEnabled(m_layout.isOpen());
    showMarker(marker());
}

void ToolLayoutDialog::showMarker(int marker)
{
    const auto markers_mm = m_layout.markers_mm();
    if (marker < 0 || marker >= int(markers_mm.size()))
        return;
    const QSignalBlocker blockNumber{m_number};
    m_number->setValue(marker + 1);
    m_picture->select(marker);
    for (std::size_t axis = 0; axis < m_places.size(); ++axis) {
        const QSignalBlocker block{m_places[axis]};
        m_places[axis]->setValue(markers_mm[std::size_t(marker)][Eigen::Index(axis)]);
    }
}

void ToolLayoutDialog::moveMarker()
{
    const Vec3 p_mm{m_places[0]->value(), m_places[1]->value(), m_places[2]->value()};
    const auto moved = m_layout.move(std::size_t(marker()), p_mm);
    m_message->warn(moved ? QString{} : errorText(moved.error()));
    if (!moved)
        showMarker(marker());
}

void ToolLayoutDialog::openFile(const QString& file)
{
    if (file.isEmpty() || m_layout.isChanged())
        return;
    const auto opened = m_layout.open(file.toStdString());
    m_message->warn(opened ? QString{} : errorText(opened.error()));
    if (opened)
        showMarker(0);
}

void ToolLayoutDialog::saveTo(const QString& file)
{
    if (file.isEmpty())
        return;
    const QString named =
        file.endsWith(QStringLiteral(".rom")) ? file : file + QStringLiteral(".rom");
    const auto saved = m_layout.saveAs(named.toStdString());
    if (saved)
        m_message->confirm(tr("Saved as %1.").arg(named));
    else
        m_message->warn(errorText(saved.error()));
}

} // namespace carina
