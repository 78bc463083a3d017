#pragma once

#include <QRect>
#include <QWidget>

#include <vector>

namespace carina
{

/// A text as a QR code (ISO/IEC 18004, error correction M), as large as fits: every module the same
/// whole number of the screen's own pixels, black on white whatever the theme, for cameras want it
/// so, with the four white modules around it that the standard asks for. A screen reader hears the
/// text.
class QrCode : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kMostCharacters = 2331; ///< in the largest code there is
    static constexpr int kQuietZone = 4;         ///< modules on each side

    /// What is drawn, in the screen's own pixels.
    struct Drawing {
        int modules = 0;           ///< along a side, without the quiet zone; 0: nothing is drawn
        int pixelsPerModule = 0;   ///< 0 where it does not fit
        QRect field{};             ///< white: the code and its quiet zone
        std::vector<QRect> dark{}; ///< the black modules
    };

    explicit QrCode(QWidget* parent = nullptr);

    /// Nothing is drawn of an empty text.
    /// @pre at most kMostCharacters, and ASCII: readers take other letters for what they like.
    void setText(const QString& text);

    [[nodiscard]] Drawing drawing() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Of a side with its quiet zone, with so many pixels to a module.
    [[nodiscard]] QSize squareOf(int pixelsPerModule) const;

    int m_modules = 0;
    std::vector<bool> m_isDark; ///< row by row
};

} // namespace carina
