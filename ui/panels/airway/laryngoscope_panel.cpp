#include "ui/panels/airway/laryngoscope_panel.h"

#include "ui/panels/airway/scope_canvas.h"
#include "ui/panels/airway/scope_controls.h"
#include "ui/panels/airway/scope_window.h"
#include "ui/scene/station_scene.h"
#include "widgets/inside_window.h"
#include "widgets/plain_label.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kRefresh_ms = 200;
constexpr int kGap = 6;            // pixels between picture and words
constexpr int kLeastWidth = 240;   // of the picture
constexpr int kUsualWidth = 400;   // likewise
constexpr int kLargestWidth = 640; // likewise, beside others
constexpr int kLeastLines = 4;     // of the words

/// The largest size of 4:3, in whole pixels, of at most this width and height.
QSize fourToThree(int width, int height)
{
    const int quarter = std::max(1, std::min(width, height * 4 / 3) / 4);
    return {4 * quarter, 3 * quarter};
}

} // namespace

LaryngoscopePanel::LaryngoscopePanel(PanelPlace place, std::shared_ptr<FlownEndoscope> endoscope,
                                     QWidget* parent)
    : QWidget{parent},
      m_place{place},
      m_endoscope{std::move(endoscope)},
      m_canvas{new ScopeCanvas{*m_endoscope, this}},
      m_controls{new ScopeControls{*m_endoscope, place == PanelPlace::WholeScreen, this}},
      m_text{new PlainLabel{this}}
{
    connect(m_canvas, &ScopeCanvas::doubleClicked, this, &LaryngoscopePanel::toggleWholeScreen);
    connect(m_controls, &ScopeControls::wholeScreenToggled, this,
            &LaryngoscopePanel::toggleWholeScreen);
    connect(m_controls, &ScopeControls::cameraChosen, this, &LaryngoscopePanel::takeCamera);
    m_text->setObjectName(QStringLiteral("laryngoscopeText"));
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_text->setToolTip(
        tr("Forces are estimates of a model, not measured. Tongue: a spring, 40 N where a good "
           "view is had (Hastings 1996). Teeth: what turning about them takes from the hand, or "
           "49 N where the blade is 5 mm deep in them (Bucx 1994)."));
    setFocusProxy(m_canvas);
    m_looking.callOnTimeout(this, &LaryngoscopePanel::refresh);
    m_looking.start(kRefresh_ms);
    refresh();
}

/// The window would else tell of its end when nothing of the panel is left.
LaryngoscopePanel::~LaryngoscopePanel()
{
    if (!m_window)
        return;
    m_window->disconnect(this);
    delete m_window;
}

void LaryngoscopePanel::setStation(StationScene& station)
{
    m_station = &station;
    refresh();
}

void LaryngoscopePanel::makePicture()
{
    m_picture = new SceneView{m_canvas};
    m_picture->setObjectName(QStringLiteral("laryngoscopePicture"));
    m_picture->setAccessibleName(tr("What the camera shows"));
    m_picture->setBackground(Qt::black);
    m_picture->takeNoInput();
    m_scope = std::make_unique<LiveScope>(*m_picture, *m_station, *m_endoscope);
    layOut();
    m_picture->show();
}

std::optional<GlotticView> LaryngoscopePanel::seen() const
{
    if (m_window)
        return m_window->panel().seen();
    return m_scope ? m_scope->seen() : std::nullopt;
}

QString LaryngoscopePanel::text() const
{
    if (m_window)
        return tr("The picture is on the whole screen: Esc there shows it here again.");
    if (isFlown()) {
        const auto place = m_endoscope->place();
        return place ? endoscopeText(*place) : QString{};
    }
    if (m_scope && m_scope->isPreparing())
        return tr("The picture is being made. This takes some seconds, the first time only.");
    return m_scope ? laryngoscopeText(m_scope->sight(), m_scope->read())
                   : laryngoscopeText(LaryngoscopeState::None);
}

std::optional<BladeEffort> LaryngoscopePanel::effort() const
{
    if (m_window)
        return m_window->panel().effort();
    const bool isShown = m_scope && isVisible() && isInsideWindow(*this);
    if (!isShown || m_scope->sight().state != LaryngoscopeState::Live)
        return std::nullopt;
    return m_scope->sight().effort;
}

bool LaryngoscopePanel::isFlown() const
{
    return m_endoscope->isFlown() && m_station && FlownEndoscope::hasAirway(m_station->patient());
}

/// Whoever chose to fly can do so at once.
void LaryngoscopePanel::takeCamera()
{
    refresh();
    if (isFlown())
        m_canvas->setFocus();
}

void LaryngoscopePanel::refresh()
{
    if (m_station && !m_picture && isVisible() && isInsideWindow(*this))
        makePicture();
    const int before = m_controls->sizeHint().height();
    m_controls->refresh(m_station && FlownEndoscope::hasAirway(m_station->patient()));
    if (m_controls->sizeHint().height() != before) {
        updateGeometry();
        layOut();
    }
    m_canvas->setAccessibleName(isFlown() ? tr("Endoscope: arrow keys turn it, W and S take it on "
                                               "and back, Q and E roll it, Home takes it in front "
                                               "of the mouth")
                                          : tr("Picture of the laryngoscope"));
    const QString told = text();
    if (told == m_text->text())
        return;
    m_text->setText(told);
    layOut();
}

/// The words keep their place beneath the picture, unless there are very many.
int LaryngoscopePanel::textHeight(int width) const
{
    return std::max(kLeastLines * fontMetrics().lineSpacing(), m_text->heightForWidth(width));
}

QSize LaryngoscopePanel::pictureIn(int width, int height) const
{
    return fourToThree(m_place == PanelPlace::Docked ? std::min(width, kLargestWidth) : width,
                       std::max(1, height));
}

/// What the controls and the words beneath a picture take, with its frame.
int LaryngoscopePanel::below(int width) const
{
    return 2 * (kGap + ScopeCanvas::kFrame) + m_controls->sizeHint().height() + textHeight(width);
}

int LaryngoscopePanel::heightForWidth(int width) const
{
    return pictureIn(width - 2 * ScopeCanvas::kFrame, kLargestWidth).height() + below(width);
}

QSize LaryngoscopePanel::sizeHint() const { return {kUsualWidth, heightForWidth(kUsualWidth)}; }

QSize LaryngoscopePanel::minimumSizeHint() const
{
    return {kLeastWidth, heightForWidth(kLeastWidth)};
}

void LaryngoscopePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOut();
}

void LaryngoscopePanel::layOut()
{
    constexpr int kFrames = 2 * ScopeCanvas::kFrame;
    const QSize size = pictureIn(width() - kFrames, height() - below(width()));
    const QSize framed = size + QSize{kFrames, kFrames};
    m_canvas->setGeometry({{(width() - framed.width()) / 2, 0}, framed});
    if (m_picture)
        m_picture->setGeometry(m_canvas->inner());
    const int controls = m_controls->sizeHint().height();
    m_controls->setGeometry(0, framed.height() + kGap, width(), controls);
    m_text->setGeometry(0, framed.height() + 2 * kGap + controls, width(), textHeight(width()));
}

void LaryngoscopePanel::toggleWholeScreen()
{
    if (m_place == PanelPlace::WholeScreen) {
        Q_EMIT wholeScreenToggled();
        return;
    }
    if (!m_station || m_window)
        return;
    m_window = new ScopeWindow{*m_station, m_endoscope, *this};
    connect(m_window, &QObject::destroyed, this, [this] {
        if (m_picture)
            m_picture->show();
        refresh();
    });
    if (m_picture)
        m_picture->hide();
    m_window->show();
    refresh();
}

/// F11 is the key of the whole window, too, while the keyboard is elsewhere.
bool LaryngoscopePanel::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F11)
        event->accept();
    return QWidget::event(event);
}

void LaryngoscopePanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_F11)
        toggleWholeScreen();
    else
        QWidget::keyPressEvent(event);
}

} // namespace carina
