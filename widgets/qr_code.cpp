#include "widgets/qr_code.h"

#include "engine/core/expects.h"

#include <QPainter>
#include <qrencode.h>

#include <algorithm>
#include <memory>

namespace carina
{
namespace
{

constexpr int kUsualModule = 4; ///< pixels
constexpr int kLeastModule = 3; ///< pixels: what a telephone still reads at arm's length

struct FreeSymbol {
    void operator()(QRcode* symbol) const { QRcode_free(symbol); }
};

bool isAscii(char c) { return (c & 0x80) == 0; }

} // namespace

QrCode::QrCode(QWidget* parent) : QWidget{parent}
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void QrCode::setText(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    CARINA_EXPECTS(bytes.size() <= kMostCharacters && std::ranges::all_of(bytes, isAscii));
    m_modules = 0;
    m_isDark.clear();
    if (!bytes.isEmpty()) {
        const std::unique_ptr<QRcode, FreeSymbol> symbol{QRcode_encodeData(
            static_cast<int>(bytes.size()),
            reinterpret_cast<const unsigned char*>(bytes.constData()), 0, QR_ECLEVEL_M)};
        CARINA_EXPECTS(symbol != nullptr); // whatever is short enough has a code
        m_modules = symbol->width;
        // The lowest bit is the colour, the others are the encoder's own.
        std::transform(symbol->data, symbol->data + m_modules * m_modules,
                       std::back_inserter(m_isDark),
                       [](unsigned char module) { return (module & 1) != 0; });
    }
    setAccessibleDescription(text);
    updateGeometry();
    update();
}

QrCode::Drawing QrCode::drawing() const
{
    Drawing drawn;
    drawn.modules = m_modules;
    if (m_modules == 0)
        return drawn;
    const double ratio = devicePixelRatioF();
    const QSize space{static_cast<int>(width() * ratio), static_cast<int>(height() * ratio)};
    const int across = m_modules + 2 * kQuietZone;
    const int module = std::min(space.width(), space.height()) / across;
    drawn.pixelsPerModule = module;
    if (module == 0)
        return drawn;
    const int side = module * across;
    drawn.field = {(space.width() - side) / 2, (space.height() - side) / 2, side, side};
    for (int row = 0; row < m_modules; ++row)
        for (int column = 0; column < m_modules; ++column)
            if (m_isDark[static_cast<std::size_t>(row * m_modules + column)])
                drawn.dark.emplace_back(drawn.field.left() + (column + kQuietZone) * module,
                                        drawn.field.top() + (row + kQuietZone) * module, module,
                                        module);
    return drawn;
}

QSize QrCode::squareOf(int pixelsPerModule) const
{
    const int side = m_modules == 0 ? 0 : (m_modules + 2 * kQuietZone) * pixelsPerModule;
    return {side, side};
}

QSize QrCode::sizeHint() const { return squareOf(kUsualModule); }

QSize QrCode::minimumSizeHint() const { return squareOf(kLeastModule); }

void QrCode::paintEvent(QPaintEvent*)
{
    const Drawing drawn = drawing();
    QPainter painter{this};
    painter.scale(1.0 / devicePixelRatioF(), 1.0 / devicePixelRatioF());
    painter.fillRect(drawn.field, Qt::white);
    for (const QRect& module : drawn.dark)
        painter.fillRect(module, Qt::black);
}

} // namespace carina
