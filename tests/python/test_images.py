"""Pictures in files, and metrics of two."""
import numpy as np
import pytest

import aktina


def noise(*shape, top=1.0):
    return np.random.default_rng(3).random(shape, np.float32) * np.float32(top)


@pytest.mark.parametrize("extension, channels", [("exr", 4), ("exr", 3), ("exr", 1), ("pfm", 3)])
def test_float_formats_are_exact(tmp_path, extension, channels):
    image = noise(7, 11, channels, top=1000)
    path = tmp_path / f"Bild ä.{extension}"
    aktina.write_image(path, image)
    back = aktina.read_image(path)
    assert back.dtype == np.float32 and back.flags.writeable
    np.testing.assert_array_equal(back, image)


def test_radiance_pictures_share_an_exponent(tmp_path):
    image = noise(7, 11, 3, top=1000)
    aktina.write_image(tmp_path / "a.hdr", image)
    error = abs(aktina.read_image(tmp_path / "a.hdr") - image)
    assert (error <= image.max(axis=2, keepdims=True) / 255).all()


@pytest.mark.parametrize("bits, error", [(8, 0.5 / 255), (16, 0.5 / 65535)])
def test_png_is_srgb(tmp_path, bits, error):
    image = noise(5, 6, 3)
    aktina.write_image(tmp_path / "a.png", image, bits=bits)

    def encoded(linear):
        return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
    assert abs(encoded(aktina.read_image(tmp_path / "a.png")) - encoded(image)).max() < error + 1e-6


def test_tone_curves_and_exposure(tmp_path):
    def written(value, **options):
        aktina.write_image(tmp_path / "a.png", np.full((4, 4, 3), value), bits=16, **options)
        return aktina.read_image(tmp_path / "a.png")[0, 0, 0]
    assert written(3.0) == 1
    assert abs(written(1.0, curve="reinhard") - 0.5) < 1e-4
    assert abs(written(50.0, exposure=None) - 0.18) < 1e-4
    assert 0.7 < written(1.0, curve="filmic") < 0.9


def test_metrics():
    a, b = noise(20, 30, 3), noise(20, 30, 3)[::-1]
    found = aktina.compare(a, b)
    difference = a.astype(float) - b
    assert found["range"] == "low"
    assert found["rmse"] == pytest.approx(np.sqrt((difference**2).mean()), rel=1e-6)
    assert found["max_error"] == pytest.approx(abs(difference).max(), rel=1e-6)
    assert found["relative_mse"] == pytest.approx((difference**2 / (b.astype(float) ** 2 + 0.01)).mean(), rel=1e-6)
    assert 0 < found["flip"] < 1 and -1 < found["ssim"] < 1
    assert aktina.compare(a * 10, b * 10)["range"] == "high"
    assert aktina.compare(a * 10, b, "low")["max_error"] <= 1
    a = a.copy()
    a[0, 0, 0] = np.nan
    assert aktina.compare(a, b)["non_finite_a"] == 1


def test_mistakes(tmp_path):
    image = noise(4, 4, 3)
    for call, error in [(lambda: aktina.write_image(tmp_path / "a.tif", image), aktina.UsageError),
                        (lambda: aktina.write_image(tmp_path / "a.png", image[0, 0]), aktina.UsageError),
                        (lambda: aktina.write_image(tmp_path / "a.png", image, curve="blue"), aktina.UsageError),
                        (lambda: aktina.write_image(tmp_path / "a.png", image, bits=12), aktina.UsageError),
                        (lambda: aktina.write_image(tmp_path / "a.png", image, exposure=-1), aktina.BadParam),
                        (lambda: aktina.write_image(tmp_path / "none" / "a.png", image), aktina.FileError),
                        (lambda: aktina.read_image(tmp_path / "none.png"), aktina.FileError),
                        (lambda: aktina.compare(image, image[:3]), aktina.UsageError),
                        (lambda: aktina.compare(image, image, "wide"), aktina.UsageError)]:
        with pytest.raises(error):
            call()
    (tmp_path / "text.png").write_text("no picture")
    with pytest.raises(aktina.BadInput):
        aktina.read_image(tmp_path / "text.png")
    (tmp_path / "claim.pfm").write_bytes(b"PF 60000 60000 -1 ")
    with pytest.raises(aktina.LimitExceeded):
        aktina.read_image(tmp_path / "claim.pfm")
