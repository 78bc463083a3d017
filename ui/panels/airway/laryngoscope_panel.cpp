#include "ui/panels/airway/laryngoscope_panel.h"

#include "widgets/inside_window.h"
#include "widgets/plain_label.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kRefresh_ms = 200;
constexpr int kGap = 6;            // pixels between picture and words
constexpr int kLeastWidth = 240;   // of the picture
constexpr int kUsualWidth = 400;   // likewise
constexpr int kLargestWidth = 640; // likewise
constexpr int kLeastLines = 4;     // of the words

/// The largest size of 4:3, in whole pixels, of at most this width and height.
QSize fourToThree(int width, int height)
{
    const int quarter = std::max(1, std::min({width, kLargestWidth, height * 4 / 3}) / 4);
    return {4 * quarter, 3 * quarter};
}

} // namespace

LaryngoscopePanel::LaryngoscopePanel(QWidget* parent)
    : QWidget{parent}, m_text{new PlainLabel{this}}
{
    m_text->setObjectName(QStringLiteral("laryngoscopeText"));
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_text->setToolTip(
        tr("Forces are estimates of a model, not measured. Tongue: a spring, 40 N where a good "
           "view is had (Hastings 1996). Teeth: what turning about them takes from the hand, or "
           "49 N where the blade is 5 mm deep in them (Bucx 1994)."));
    m_text->setFocusPolicy(Qt::ClickFocus); // by no Tab, but where the panel is brought
    setFocusProxy(m_text);
    m_looking.callOnTimeout(this, &LaryngoscopePanel::refresh);
    m_looking.start(kRefresh_ms);
    refresh();
}

void LaryngoscopePanel::setStation(StationScene& station)
{
    m_station = &station;
    refresh();
}

void LaryngoscopePanel::makePicture()
{
    m_picture = new SceneView{this};
    m_picture->setObjectName(QStringLiteral("laryngoscopePicture"));
    m_picture->setAccessibleName(tr("What the camera of the laryngoscope shows"));
    m_picture->setBackground(Qt::black);
    m_picture->takeNoInput();
    m_scope = std::make_unique<LiveScope>(*m_picture, *m_station);
    layOut();
    m_picture->show();
}

QString LaryngoscopePanel::text() const
{
    return m_scope ? laryngoscopeText(m_scope->sight(), m_scope->seen())
                   : laryngoscopeText(LaryngoscopeState::None);
}

std::optional<BladeEffort> LaryngoscopePanel::effort() const
{
    const bool isShown = m_scope && isVisible() && isInsideWindow(*this);
    if (!isShown || m_scope->sight().state != LaryngoscopeState::Live)
        return std::nullopt;
    return m_scope->sight().effort;
}

void LaryngoscopePanel::refresh()
{
    if (m_station && !m_picture && isVisible() && isInsideWindow(*this))
        makePicture();
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

int LaryngoscopePanel::heightForWidth(int width) const
{
    const QSize picture = fourToThree(width, kLargestWidth);
    return picture.height() + kGap + textHeight(width);
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
    const int words = textHeight(width());
    const QSize size = fourToThree(width(), std::max(1, height() - kGap - words));
    if (m_picture)
        m_picture->setGeometry({{(width() - size.width()) / 2, 0}, size});
    m_text->setGeometry(0, size.height() + kGap, width(), words);
}

} // namespace carina
