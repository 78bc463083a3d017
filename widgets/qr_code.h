#pragma once

#include <QRect>
#include <QWidget>

#include <vector>

namespace carina
{

/// A text as a QR code (ISO/IEC 18004, error correction level M), as large as fits: each module is
/// the same whole number of device pixels, black on white in every theme, as cameras need it, with
/// the quiet zone of four modules that the standard requires. The text is the accessible
/// description.
class QrCode : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kMostCharacters = 2331; ///< capacity of the largest code
    static constexpr int kQuietZone = 4;         ///< modules on each side

    /// What is drawn, in device pixels.
    struct Drawing {
        int modules = 0;           ///< per side, without the quiet zone; 0: nothing is drawn
        int pixelsPerModule = 0;   ///< 0 if the code does not fit
        QRect field{};             ///< white: the code and its quiet zone
        std::vector<QRect> dark{}; ///< the black modules
    };

    explicit QrCode(QWidget* parent = nullptr);

    /// An empty text draws nothing.
    /// @pre at most kMostCharacters of ASCII: readers interpret other characters differently.
    void setText(const QString& text);

    [[nodiscard]] Drawing drawing() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// The size of the code with its quiet zone at this scale.
    [[nodiscard]] QSize squareOf(int pixelsPerModule) const;

    int m_modules = 0;
    std::vector<bool> m_isDark; ///< row by row
};

} // namespace carina
