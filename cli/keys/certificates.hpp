#pragma once

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <memory>
#include <string>

/// X.509 certificates and S/MIME signatures, by OpenSSL. Everything throws std::runtime_error with OpenSSL's reason.
namespace mrroc::cli {

using PrivateKey = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;
using Certificate = std::unique_ptr<X509, decltype(&X509_free)>;

/// A new key on the curve P-256.
PrivateKey new_private_key();

/// What a certificate is for: to sign others and documents, or to be a process of a deployment.
enum class CertificateUse { authority, identity };

/// A certificate of `name` for `key`, signed by `issuer` with `issuer_key`; `issuer` null: self-signed. Valid 2000 to
/// 2099.
Certificate certify(const std::string& name, EVP_PKEY* key, CertificateUse use, X509* issuer, EVP_PKEY* issuer_key);

/// As PEM text. The key is not encrypted.
std::string to_pem(X509* certificate);
std::string to_pem(EVP_PKEY* key);

/// The document with its signature, in clear text (S/MIME, multipart/signed), as DDS Security requires.
std::string sign_document(const std::string& document, X509* signer, EVP_PKEY* key);

}  // namespace mrroc::cli
